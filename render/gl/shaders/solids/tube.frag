// SPDX-License-Identifier: MIT
in vec3 v_side;
in vec3 v_toward;
in vec4 v_color;
in vec2 v_across_along;
in vec3 v_point;
uniform vec3 u_light;         // unit, towards the key light
uniform vec3 u_eye;
uniform float u_sunk_below;  // height under which things are seen through the floor
uniform float u_sunk;        // what they keep of themselves there
out vec4 o_color;

void main() {
  float dash = fract(0.5 * v_across_along.y);
  if (dash > 0.5) discard;
  float c = v_across_along.x;
  vec3 n = normalize(c * v_side + sqrt(max(1.0 - c * c, 0.0)) * v_toward);
  float alpha = v_color.a * (v_point.z < u_sunk_below ? u_sunk : 1.0);
  o_color = vec4(lit(v_color.rgb, n, u_light, normalize(u_eye - v_point), 0.58, 0.32) * alpha, alpha);
}
