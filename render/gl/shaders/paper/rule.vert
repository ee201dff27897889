// SPDX-License-Identifier: MIT
// Boxes of any direction: pixels from the upper left.
layout(location = 0) in vec2 a_position;  // px
layout(location = 1) in vec2 a_local;     // px from the middle, along and across
layout(location = 2) in vec2 a_half;      // length and thickness, px
layout(location = 3) in vec4 a_color;     // premultiplied
uniform vec2 u_size;  // of the picture, px
out vec2 v_local;
flat out vec2 v_half;
flat out vec4 v_color;
void main() {
  v_local = a_local;
  v_half = a_half;
  v_color = a_color;
  vec2 p = 2.0 * a_position / u_size - 1.0;
  gl_Position = vec4(p.x, -p.y, 0.0, 1.0);
}
