// SPDX-License-Identifier: MIT
// A rectangle of the viewport.
uniform vec4 u_bounds;  // x0, y0, x1, y1 in clip space
uniform vec4 u_window;  // clip space to noise(): offset, factor
noperspective out vec2 v_sky;
noperspective out vec2 v_place;
void main() {
  vec2 clip = mix(u_bounds.xy, u_bounds.zw, vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)));
  gl_Position = vec4(clip, 0.0, 1.0);
  v_sky = sky_place(clip);
  v_place = u_window.xy + clip * u_window.zw;
}
