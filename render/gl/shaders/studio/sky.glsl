// SPDX-License-Identifier: MIT
// The studio's gradient, of a place that is linear in clip space.
vec2 sky_place(vec2 clip) { return (0.5 * clip - vec2(0.0, 0.12)) * vec2(1.25, 1.0); }

vec3 studio(vec2 place) {
  float dark = min(1.25 * dot(place, place), 1.0);
  return vec3(0.945, 0.949, 0.953) - dark * vec3(0.21, 0.184, 0.158);
}
