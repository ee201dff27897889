// A rectangle of the screen.
#version 330 core
uniform vec4 u_bounds;  // x0, y0, x1, y1 in clip space
out vec2 v_clip;
void main() {
  v_clip = mix(u_bounds.xy, u_bounds.zw, vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)));
  gl_Position = vec4(v_clip, 0.0, 1.0);
}
