// SPDX-License-Identifier: MIT
// A tube as a ribbon of two triangles a piece that faces the viewer, wider and longer by the soft edge of a pixel.
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_tangent;  // unit
layout(location = 2) in vec4 a_color;    // straight alpha
layout(location = 3) in vec4 a_shape;    // side -1 or +1, radius, 1 / length of dash and gap (0: solid), wider for the bow
layout(location = 4) in vec2 a_along;    // lengths from the first end: of this vertex, of the whole
layout(location = 5) in vec3 a_bow;      // from the middle of the piece's chord to that of the curve, a parabola
layout(location = 6) in float a_end;     // of the piece: 0 or 1
uniform mat4 u_view_projection;
uniform vec3 u_eye;
uniform float u_pixel;  // its side at distance 1 along the line of sight
uniform float u_level;  // height below which things are fainter, or not drawn
uniform vec3 u_light;   // unit, towards the key light
invariant gl_Position;  // the depth comes from another program
flat out vec4 v_color;
out vec4 v_light;   // shares of the light in the ribbon's side and front, of the viewer in the front, 1 / halfway
out vec4 v_px;      // across, half width, to the nearer end, above the level
out vec2 v_bow;     // along the piece, 0 to 1; 4 times the bow to the side, px
out vec2 v_dash;    // dashes; pixels to a dash and a gap
#if GLASSES > 0
#ifndef GL_ES
uniform Glass u_glass[GLASSES];
#endif
uniform mat3 u_to_ball[GLASSES];
#ifndef GL_ES
flat out Glass v_glass[GLASSES];  // flat for the reason in floor.vert; of WebGL's 15 varyings it would take too many
#endif
out vec3 v_towards[GLASSES];           // of the chord
flat out vec3 v_towards_bow[GLASSES];  // what its bow adds, times 4
out vec2 v_ray;     // 1 / length, cosine of the angle with the key light
#endif
void main() {
  const float kSoft = 0.8;  // px; half of it would do for edges along rows and columns
  float pixel = u_pixel * (u_view_projection * vec4(a_position, 1.0)).w;
  float longer = kSoft * pixel * (float(a_along.x == a_along.y) - float(a_along.x == 0.0));
  vec3 position = a_position + longer * a_tangent;
  vec3 to_eye = normalize(u_eye - position);
  vec3 side = cross(a_tangent, to_eye);
  side /= max(length(side), 1e-4);  // end-on pieces shrink instead of jumping
  float half_width = a_shape.y + a_shape.w + kSoft * pixel;
  vec3 point = position + a_shape.x * half_width * side;
  vec4 clip = u_view_projection * vec4(point, 1.0);
  vec4 front = u_view_projection * vec4(point + a_shape.y * to_eye, 1.0);
  gl_Position = vec4(clip.xy, clip.w * front.z / front.w, clip.w);  // depth of the cylinder's near side
  vec3 toward = normalize(cross(side, a_tangent)), near = point + a_shape.y * to_eye - u_eye;
  float per_length = 1.0 / length(near), eye_light = -dot(near, u_light) * per_length;
  v_light = vec4(dot(side, u_light), dot(toward, u_light), -dot(toward, near) * per_length,
                 inversesqrt(max(2.0 + 2.0 * eye_light, 1e-6)));
  v_color = a_color;
  float along = a_along.x + longer;
  float shown = length(cross(a_tangent, to_eye)) / pixel;  // px to a length of 1 along the tube
  v_px = vec4(a_shape.x * half_width / pixel, a_shape.y / pixel, min(along, a_along.y - along) * shown,
              (point.z - u_level) / pixel);
  v_bow = vec2(a_end, 4.0 * dot(a_bow, side) / pixel);
  v_dash = a_shape.z > 0.0 ? vec2(0.5 * along * a_shape.z, 2.0 * shown / a_shape.z) : vec2(0.25, 4.0);
#if GLASSES > 0
  for (int i = 0; i < GLASSES; ++i) {
#ifndef GL_ES
    v_glass[i] = u_glass[i];
#endif
    v_towards[i] = u_to_ball[i] * near;
    v_towards_bow[i] = u_to_ball[i] * (4.0 * a_bow);
  }
  v_ray = vec2(per_length, -eye_light);
#endif
}
