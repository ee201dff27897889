// SPDX-License-Identifier: MIT
// A polygon around the outline of a glass ellipsoid, with the rays through it. What is the same in all pixels is flat,
// as in floor.vert.
layout(location = 0) in vec2 a_clip;  // nothing of it beyond the screen (outline_polygon)
uniform mat4 u_ray;    // clip (x, y, 1, 1) -> direction in the view's frame
uniform vec3 u_light;  // unit, towards the key light
uniform mat3 u_to_ball;
uniform Glass u_glass;
uniform float u_fineness;
noperspective out vec3 v_ray;
noperspective out vec3 v_towards;
noperspective out float v_to_light;
flat out vec3 v_eye;
flat out vec3 v_per_axis;
flat out vec3 v_up;
flat out vec3 v_light;
flat out vec3 v_tint;
flat out vec2 v_graticule_fineness;
void main() {
  gl_Position = vec4(a_clip, 0.0, 1.0);
  v_ray = (u_ray * vec4(a_clip, 1.0, 1.0)).xyz;
  v_towards = u_to_ball * v_ray;
  v_to_light = dot(v_ray, u_light);
  v_eye = u_glass.eye;
  v_per_axis = u_glass.per_axis;
  v_up = u_glass.up;
  v_light = u_glass.light;
  v_tint = u_glass.tint;
  v_graticule_fineness = vec2(u_glass.graticule, u_fineness);
}
