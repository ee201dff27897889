// A rectangle of the viewport with the rays through a glass ellipsoid. What is the same in all pixels is flat, as in
// floor.vert.
uniform vec4 u_bounds;  // x0, y0, x1, y1 in clip space
uniform mat4 u_ray;     // clip (x, y, 1, 1) -> direction in the view's frame
uniform vec3 u_light;   // unit, towards the key light
uniform mat3 u_to_ball;
uniform Glass u_glass;
uniform float u_fineness;
out vec3 v_ray;
out vec3 v_towards;
out float v_to_light;
flat out vec3 v_eye;
flat out vec3 v_per_axis;
flat out vec3 v_up;
flat out vec3 v_light;
flat out vec3 v_tint;
flat out vec2 v_graticule_fineness;
void main() {
  vec2 clip = mix(u_bounds.xy, u_bounds.zw, vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)));
  gl_Position = vec4(clip, 0.0, 1.0);
  v_ray = (u_ray * vec4(clip, 1.0, 1.0)).xyz;
  v_towards = u_to_ball * v_ray;
  v_to_light = dot(v_ray, u_light);
  v_eye = u_glass.eye;
  v_per_axis = u_glass.per_axis;
  v_up = u_glass.up;
  v_light = u_glass.light;
  v_tint = u_glass.tint;
  v_graticule_fineness = vec2(u_glass.graticule, u_fineness);
}
