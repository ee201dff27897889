// The studio's light on opaque things.
uniform vec3 u_light;  // unit, towards the key light

/// @param n, to_eye unit
vec3 lit(vec3 base, vec3 n, vec3 to_eye, float diffuse, float gloss) {
  float to_light = dot(n, u_light);
  // The normal's share of the direction halfway between light and viewer.
  float s = max((to_light + dot(n, to_eye)) * inversesqrt(2.0 + 2.0 * dot(u_light, to_eye)), 0.0);
  s *= s; s *= s; s *= s; s *= s; s *= s;
  return base * (0.50 + 0.5 * diffuse + 0.5 * diffuse * to_light) + vec3(gloss * s);
}
