// SPDX-License-Identifier: MIT
// The studio's light on opaque things.

/// @param to_light, to_halfway the normal's share of the direction to the key light, and of that halfway to the viewer
vec3 lit(vec3 base, float to_light, float to_halfway, float diffuse, float gloss) {
  float s = max(to_halfway, 0.0);
  s *= s; s *= s; s *= s; s *= s; s *= s;
  return base * (0.50 + 0.5 * diffuse + 0.5 * diffuse * to_light) + vec3(gloss * s);
}

/// The same from directions, all unit.
vec3 lit(vec3 base, vec3 n, vec3 light, vec3 to_eye, float diffuse, float gloss) {
  float to_light = dot(n, light);
  float to_halfway = (to_light + dot(n, to_eye)) * inversesqrt(max(2.0 + 2.0 * dot(light, to_eye), 1e-6));
  return lit(base, to_light, to_halfway, diffuse, gloss);
}
