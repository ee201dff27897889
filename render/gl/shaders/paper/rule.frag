// SPDX-License-Identifier: MIT
// The part of the pixel that the box covers, as RuleBox::coverage.
in vec2 v_local;
flat in vec2 v_half;
flat in vec4 v_color;
out vec4 o_color;
void main() {
  vec2 covered = clamp(min(v_local + 0.5, v_half) - max(v_local - 0.5, -v_half), 0.0, 1.0);
  o_color = v_color * (covered.x * covered.y);
}
