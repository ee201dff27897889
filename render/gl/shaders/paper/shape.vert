// SPDX-License-Identifier: MIT
// Flat shapes: pixels from the upper left.
layout(location = 0) in vec2 a_position;  // px
layout(location = 1) in vec4 a_color;     // premultiplied
layout(location = 2) in vec4 a_piece;     // of ShapeVertex
uniform vec2 u_size;  // of the picture, px
out vec4 v_color;
out vec4 v_piece;
void main() {
  v_color = a_color;
  v_piece = a_piece;
  vec2 p = 2.0 * a_position / u_size - 1.0;
  gl_Position = vec4(p.x, -p.y, 0.0, 1.0);
}
