// SPDX-License-Identifier: MIT
// What lies behind the near sides of the glass ellipsoids, of which there are GLASSES. They are laid over each thing by
// itself and not over the picture: laying over is affine, so things that cover one another partly come out the same.
uniform float u_fineness;  // of pixels to a side that are averaged into one: lines keep their width

/// @param color of a thing where the ray ends, after a way of 1
vec3 behind_glass(vec3 color, Glass glass, Ray ray) {
  Chord chord = chord_of(glass, ray);
  float depth = 1.0 - (chord.middle - chord.half_length);
  // What lies on the glass is in front of it: the soft edge begins behind.
  float behind = clamp(depth / max(fwidth(depth), 1e-6), 0.0, 1.0);
  vec3 ball = near_point(glass, chord, ray), normal = normal_at(glass, ball);
  vec4 side = behind * near_side(glass, chord, ray, ball, inversesqrt(dot(normal, normal)), u_fineness);
  return side.rgb + (1.0 - side.a) * color;
}
