// SPDX-License-Identifier: MIT
// A rectangle of the viewport with the rays through it, linear on the screen. What is the same in all pixels is flat:
// on the software rasteriser uniforms cost more in a fragment shader than most arithmetic. w is 1: `noperspective`
// changes the cost alone, and GLSL ES, which lacks it, may define it as nothing.
uniform vec4 u_bounds;   // x0, y0, x1, y1 in clip space
uniform vec4 u_window;   // clip space to noise(): offset, factor
uniform mat4 u_ray;      // clip (x, y, 1, 1) -> direction in the view's frame
uniform vec2 u_step;     // of a pixel in clip space, or of those that are averaged into one: lines keep their width
uniform vec3 u_eye;
uniform float u_floor_z;
uniform float u_cells;   // of the grid's heavier lines, to a length of 1
uniform vec2 u_fade;     // distances where the floor starts to fade, and ends
uniform vec3 u_near, u_far;  // its colour below the body, and further out
uniform vec3 u_line;
noperspective out vec3 v_floor;  // where the ray meets the floor, homogeneous: x / z and y / z in cells
flat out vec3 v_right;           // what a pixel's step to the right adds to it
flat out vec3 v_up;              // and a step up
flat out vec3 v_reach;           // of a distance in cells: towards the far colour; start and speed of the fading
flat out vec3 v_near;
flat out vec3 v_far_less_near;
flat out vec3 v_line;
noperspective out vec2 v_place;
#ifdef STUDIO
noperspective out vec2 v_sky;
#else
uniform vec4 u_sky;  // premultiplied
flat out vec4 v_sky;
#endif
#ifdef BALL
uniform vec3 u_from_ball[3];         // as FloorForm has it
noperspective out vec3 v_from_ball;  // u, v and way to the light, times v_floor.z
flat out float v_beside;             // w squared
#endif
#ifdef MIRROR
uniform mat3 u_to_ball;
uniform vec3 u_ball_center, u_tint;
noperspective out vec3 v_ball_ray;  // the ray in the ball's space, for a way of 1 / v_floor.z
flat out vec3 v_ball_eye;
flat out vec3 v_ball_up;            // of the ray's vertical part, to be turned over in the mirror
flat out vec3 v_image;
#endif

void main() {
  vec2 clip = mix(u_bounds.xy, u_bounds.zw, vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)));
  gl_Position = vec4(clip, 0.0, 1.0);
  vec3 direction = (u_ray * vec4(clip, 1.0, 1.0)).xyz;
  float height = u_floor_z - u_eye.z;
  // From the direction of a ray to where it meets the floor.
  mat3 meet = mat3(u_cells, 0.0, 0.0, 0.0, u_cells, 0.0, vec3(u_cells * u_eye.xy, 1.0) / height);
  v_floor = meet * direction;
  v_right = u_step.x * (meet * u_ray[0].xyz);
  v_up = u_step.y * (meet * u_ray[1].xyz);
  v_reach = vec3(0.2, u_fade.x * u_cells, 1.0 / (u_fade.y - u_fade.x)) / vec3(u_cells, 1.0, u_cells);
  v_near = u_near;
  v_far_less_near = u_far - u_near;
  v_line = u_line;
  v_place = u_window.xy + clip * u_window.zw;
#ifdef STUDIO
  v_sky = sky_place(clip);
#else
  v_sky = u_sky;
#endif
#ifdef BALL
  v_from_ball = vec3(dot(u_from_ball[0], v_floor), dot(u_from_ball[1].xy, v_floor.yz), dot(u_from_ball[2], v_floor));
  v_beside = u_from_ball[1].z;
#endif
#ifdef MIRROR
  v_ball_ray = u_to_ball * direction;
  v_ball_eye = u_to_ball * (u_eye - u_ball_center);
  v_ball_up = u_to_ball[2] * (2.0 * height);
  v_image = u_tint;
#endif
}
