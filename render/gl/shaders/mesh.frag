#version 330 core
in vec3 v_normal;
in vec3 v_point;
in vec4 v_color;
uniform vec3 u_light;
uniform vec3 u_eye;
uniform float u_sunk_below;
out vec4 o_color;
void main() {
  vec3 to_eye = normalize(u_eye - v_point);
  vec3 n = normalize(v_normal);
  n *= sign(dot(n, to_eye) + 1e-6);  // both sides are lit
  float key = 0.5 + 0.5 * dot(n, u_light);
  vec3 halfway = normalize(u_light + to_eye);
  float s = max(dot(n, halfway), 0.0);
  s *= s; s *= s; s *= s; s *= s; s *= s;
  float alpha = v_color.a * (v_point.z < u_sunk_below ? 0.42 : 1.0);
  o_color = vec4((v_color.rgb * (0.50 + 0.56 * key) + vec3(0.18 * s)) * alpha, alpha);
}
