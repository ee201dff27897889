#version 330 core
in vec3 v_side;
in vec3 v_toward;
in vec4 v_color;
in vec2 v_across_along;
in vec3 v_point;
uniform vec3 u_light;
uniform vec3 u_eye;
uniform float u_sunk_below;  // height under which things are seen through the floor
out vec4 o_color;

vec3 lit(vec3 base, vec3 n, vec3 to_eye) {
  float key = 0.5 + 0.5 * dot(n, u_light);
  vec3 halfway = normalize(u_light + to_eye);
  float s = max(dot(n, halfway), 0.0);
  s *= s; s *= s; s *= s; s *= s; s *= s;
  return base * (0.50 + 0.58 * key) + vec3(0.32 * s);
}

void main() {
  float dash = fract(0.5 * v_across_along.y);
  if (dash > 0.5) discard;
  float c = v_across_along.x;
  vec3 n = normalize(c * v_side + sqrt(max(1.0 - c * c, 0.0)) * v_toward);
  float alpha = v_color.a * (v_point.z < u_sunk_below ? 0.42 : 1.0);
  o_color = vec4(lit(v_color.rgb, n, normalize(u_eye - v_point)) * alpha, alpha);
}
