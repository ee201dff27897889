// Interleaved gradient noise (Jimenez 2014), half a level either way: gradients do not band, and bytes repeat.
// The same for 16 pixels of a row, so that a PNG stays half as large, and for those that are averaged into one.
vec3 noise(float fineness) {
  float per_pixel = 1.0 / fineness;
  float column = floor(gl_FragCoord.x * (0.0625 * per_pixel)), row = floor(gl_FragCoord.y * per_pixel) + 0.5;
  float n = fract(52.9829189 * fract(0.46978392 * column + 0.00583715 * row));
  return vec3(n * (1.0 / 255.0) - 0.5 / 255.0);
}
