// SPDX-License-Identifier: MIT
// A tube as a ribbon of two triangles a segment that faces the viewer, shaded as a cylinder.
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_tangent;  // unit
layout(location = 2) in vec4 a_color;    // straight alpha
layout(location = 3) in vec3 a_shape;    // side -1 or +1, radius, length along the tube in dashes (0: solid)
uniform mat4 u_view_projection;
uniform vec3 u_eye;
out vec3 v_side;
out vec3 v_toward;
out vec4 v_color;
out vec2 v_across_along;
out vec3 v_point;
void main() {
  vec3 to_eye = normalize(u_eye - a_position);
  vec3 side = cross(a_tangent, to_eye);
  side /= max(length(side), 1e-4);  // end-on segments shrink instead of jumping
  vec3 toward = normalize(cross(side, a_tangent));
  vec3 point = a_position + a_shape.x * a_shape.y * side;
  vec4 clip = u_view_projection * vec4(point, 1.0);
  vec4 front = u_view_projection * vec4(point + a_shape.y * to_eye, 1.0);
  gl_Position = vec4(clip.xy, clip.w * front.z / front.w, clip.w);  // depth of the cylinder's near side
  v_side = side;
  v_toward = toward;
  v_color = a_color;
  v_across_along = vec2(a_shape.x, a_shape.z);
  v_point = point;
}
