// SPDX-License-Identifier: MIT
// A ball, or (CONE) one or two cones, as a rectangle that faces the viewer and holds it.
layout(location = 0) in vec2 a_corner;  // -1 or +1
layout(location = 1) in vec3 a_from;    // middle of the ball; of the base of the last cone
layout(location = 2) in vec3 a_to;      // tip of the first cone
layout(location = 3) in vec4 a_color;   // straight alpha
layout(location = 4) in vec2 a_shape;    // radius; height of a cone
uniform mat4 u_view_projection;
uniform vec3 u_eye;
uniform vec3 u_right;  // of the screen
uniform float u_pixel;
flat out vec3 v_from;
flat out vec3 v_to;
flat out vec4 v_color;
flat out vec2 v_shape;
out vec3 v_ray;
void main() {
  vec3 middle = 0.5 * (a_from + a_to), axis = a_to - a_from;
  vec3 to_eye = normalize(u_eye - middle);
  vec3 across = cross(axis, to_eye);
  across = dot(across, across) > 1e-12 ? normalize(across) : u_right;
  vec3 along = cross(to_eye, across);
  float length_shown = abs(dot(axis, along)), whole = max(length(axis), 1e-6);
  // The base, or the ball's great circle, leans by the rest of it; in perspective both look larger.
  float leaning = a_shape.x * sqrt(max(1.0 - length_shown * length_shown / (whole * whole), 0.0));
  float pixel = u_pixel * (u_view_projection * vec4(middle, 1.0)).w;
  vec2 half_size = 1.1 * vec2(a_shape.x, 0.5 * length_shown + leaning) + 2.0 * pixel;
  vec3 corner = middle + a_corner.x * half_size.x * across + a_corner.y * half_size.y * along;
  gl_Position = u_view_projection * vec4(corner, 1.0);
  v_ray = corner - u_eye;
  v_from = a_from;
  v_to = a_to;
  v_color = a_color;
  v_shape = a_shape;
}
