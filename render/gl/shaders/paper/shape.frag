// SPDX-License-Identifier: MIT
// A piece of a stroke is covered up to its radius from its middle line, fading over one pixel.
in vec4 v_color;
in vec4 v_piece;  // along, across, half length, radius; px
out vec4 o_color;
void main() {
  float beyond = max(abs(v_piece.x) - v_piece.z, 0.0);
  float distance = length(vec2(beyond, v_piece.y));
  o_color = v_color * clamp(v_piece.w + 0.5 - distance, 0.0, 1.0);
}
