// SPDX-License-Identifier: MIT
// Rounded box with a border; a box one line high and long is a leader line.
in vec2 v_local;
flat in vec4 v_ink;
flat in vec4 v_halo;
out vec4 o_color;
void main() {
  vec2 q = abs(v_local) - v_halo.xy + v_halo.z;
  float distance = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - v_halo.z;
  float coverage = clamp(0.5 - distance, 0.0, 1.0);
  float border = v_halo.w > 0.0 ? clamp(distance + v_halo.w + 0.5, 0.0, 1.0) : 0.0;
  vec3 color = mix(v_ink.rgb, vec3(0.60, 0.64, 0.69), border);
  float alpha = mix(v_ink.a, 1.0, 0.6 * border) * coverage;
  o_color = vec4(color * alpha, alpha);
}
