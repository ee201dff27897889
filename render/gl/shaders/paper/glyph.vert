// SPDX-License-Identifier: MIT
// Masks of the atlas: pixels from the upper left.
layout(location = 0) in vec2 a_position;  // px
layout(location = 1) in vec2 a_texel;
layout(location = 2) in vec4 a_color;  // premultiplied
layout(location = 3) in float a_gain;
uniform vec2 u_size;  // of the picture, px
out vec2 v_texel;
flat out vec4 v_color;
flat out float v_gain;
void main() {
  v_texel = a_texel;
  v_color = a_color;
  v_gain = a_gain;
  vec2 p = 2.0 * a_position / u_size - 1.0;
  gl_Position = vec4(p.x, -p.y, 0.0, 1.0);
}
