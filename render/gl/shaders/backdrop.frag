// The studio's gradient.
#version 330 core
uniform vec2 u_viewport_origin;  // px
uniform vec2 u_viewport_size;    // px
uniform float u_fineness;        // of pixels to a side that are averaged into one: the noise is the same in all
out vec4 o_color;

void main() {
  vec2 d = ((gl_FragCoord.xy - u_viewport_origin) / u_viewport_size - vec2(0.5, 0.62)) * vec2(1.25, 1.0);
  vec3 studio = mix(vec3(0.945, 0.949, 0.953), vec3(0.735, 0.765, 0.795), clamp(1.25 * dot(d, d), 0.0, 1.0));
  // Interleaved gradient noise (Jimenez 2014), half a level either way: the gradient does not band, and bytes repeat.
  // The same for 16 pixels of a row, so that a PNG stays half as large.
  vec2 pixel = floor(gl_FragCoord.xy / u_fineness) + 0.5;
  vec2 cell = vec2(floor(pixel.x / 16.0) * 7.0, pixel.y);
  float noise = fract(52.9829189 * fract(dot(cell, vec2(0.06711056, 0.00583715)))) - 0.5;
  o_color = vec4(studio + noise / 255.0, 1.0);
}
