// SPDX-License-Identifier: MIT
// Labels, leader lines and panels: rectangles in pixels from the lower left.
layout(location = 0) in vec2 a_position;  // px
layout(location = 1) in vec2 a_local;     // texels of the mask, or px from the middle of a rounded box
layout(location = 2) in vec4 a_ink;       // straight alpha
layout(location = 3) in vec4 a_halo;      // straight alpha; of boxes: half width, half height, corner radius, border
uniform vec2 u_size;  // of the picture, px
flat out vec4 v_halo;
flat out vec4 v_ink;
out vec2 v_local;
void main() {
  v_local = a_local;
  v_ink = a_ink;
  v_halo = a_halo;
  gl_Position = vec4(2.0 * a_position / u_size - 1.0, 0.0, 1.0);
}
