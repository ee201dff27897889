// SPDX-License-Identifier: MIT
// Interleaved gradient noise (Jimenez 2014), half a level either way: gradients do not band, and bytes repeat.
// The same for 16 pixels of a row, so that a PNG stays half as large, and for those that are averaged into one.
/// @param place column / 16 and row of the pixel, from u_window, as the vertex shaders have it
vec3 noise(vec2 place) {
  float n = fract(52.9829189 * fract(0.46978392 * floor(place.x) + 0.00583715 * (floor(place.y) + 0.5)));
  return vec3(n * (1.0 / 255.0) - 0.5 / 255.0);
}
