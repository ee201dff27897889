// SPDX-License-Identifier: MIT
// The depth of a piece of a tube where it hides whole pixels.
flat in vec4 v_color;
in vec4 v_px;     // as in stroke.frag
in vec2 v_bow;
in vec2 v_dash;
void main() {
  float gap = abs(fract(v_dash.x + 0.25) - 0.5);
  float beside = v_px.x - v_bow.x * (1.0 - v_bow.x) * v_bow.y;
  float inside = min(min(v_px.y - abs(beside), v_px.z), (0.25 - gap) * v_dash.y);  // px
  if (inside < 0.5 || v_color.a < 0.99) discard;
}
