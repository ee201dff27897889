// SPDX-License-Identifier: MIT
// A wall of the room, larger than it is by the soft edge of its outermost lines. What is the same in all pixels is flat,
// for the reason in floor.vert.
uniform mat4 u_view_projection;
uniform vec3 u_center, u_right, u_up;  // half edges
uniform vec2 u_cells;      // of the grid, along both
uniform vec2 u_half_line;  // half the width of its lines, in cells
uniform vec4 u_line;       // premultiplied, as the ground
uniform vec4 u_ground;
out vec2 v_place;          // in cells from the first corner
flat out vec2 v_cells;
flat out vec2 v_half_line;
flat out vec4 v_line;
flat out vec4 v_ground;
void main() {
  const float kBeyond = 1.04;
  vec2 corner = kBeyond * (2.0 * vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) - 1.0);
  gl_Position = u_view_projection * vec4(u_center + corner.x * u_right + corner.y * u_up, 1.0);
  v_place = (0.5 * corner + 0.5) * u_cells;
  v_cells = u_cells;
  v_half_line = u_half_line;
  v_line = u_line;
  v_ground = u_ground;
}
