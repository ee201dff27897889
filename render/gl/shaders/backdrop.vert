// A rectangle of the viewport.
uniform vec4 u_bounds;  // x0, y0, x1, y1 in clip space
uniform float u_fineness;
out vec2 v_sky;
flat out float v_fineness;
void main() {
  vec2 clip = mix(u_bounds.xy, u_bounds.zw, vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)));
  gl_Position = vec4(clip, 0.0, 1.0);
  v_sky = sky_place(clip);
  v_fineness = u_fineness;
}
