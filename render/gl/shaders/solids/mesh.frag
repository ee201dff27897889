// SPDX-License-Identifier: MIT
in vec3 v_normal;
in vec3 v_point;
in vec4 v_color;
uniform vec3 u_light;         // unit, towards the key light
uniform vec3 u_eye;
uniform float u_sunk_below;  // height under which things are seen through the floor
uniform float u_sunk;        // what they keep of themselves there
out vec4 o_color;
void main() {
  vec3 to_eye = normalize(u_eye - v_point);
  vec3 n = normalize(v_normal);
  n *= sign(dot(n, to_eye) + 1e-6);  // both sides are lit
  float alpha = v_color.a * (v_point.z < u_sunk_below ? u_sunk : 1.0);
  o_color = vec4(lit(v_color.rgb, n, u_light, to_eye, 0.56, 0.18) * alpha, alpha);
}
