// SPDX-License-Identifier: MIT
// Ground and grid of a wall, each with the part of the pixel that it covers; lines fade where they crowd. Output is
// premultiplied.
in vec2 v_place;
flat in vec2 v_cells;
flat in vec2 v_half_line;
flat in vec4 v_line;
flat in vec4 v_ground;
out vec4 o_color;

void main() {
  vec2 dx = dFdx(v_place), dy = dFdy(v_place);
  vec2 sharp = inversesqrt(max(dx * dx + dy * dy, 1e-12));  // pixels to a cell
  vec2 half_line = v_half_line * sharp;
  vec2 beside = abs(v_place - roundEven(v_place)) * sharp;
  vec2 lines = clamp(min(half_line, beside + 0.5) - max(-half_line, beside - 0.5), 0.0, 1.0) *
               clamp(0.25 * sharp - 0.5, 0.0, 1.0);
  vec2 within = clamp(min(v_place, v_cells - v_place) * sharp + half_line + 0.5, 0.0, 1.0);
  float line = max(lines.x, lines.y);
  vec4 color = v_ground * (1.0 - v_line.a * line) + v_line * line;
  o_color = color * (within.x * within.y);
}
