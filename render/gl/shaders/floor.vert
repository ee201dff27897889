// A rectangle of the viewport with the rays through it, linear on the screen. What is the same in all pixels is flat:
// on the software rasteriser uniforms cost more in a fragment shader than most arithmetic.
uniform vec4 u_bounds;   // x0, y0, x1, y1 in clip space
uniform mat4 u_ray;      // clip (x, y, 1, 1) -> direction in the view's frame
uniform vec3 u_eye;
uniform float u_floor_z;
uniform float u_cells;   // of the grid's heavier lines, to a length of 1
uniform vec2 u_fade;     // distances where the floor starts to fade, and ends
uniform float u_fineness;
uniform vec3 u_near, u_far;  // its colour below the body, and further out
uniform vec3 u_line;
out vec3 v_ray;           // in cells; the height of the eye above the floor is 1
flat out vec2 v_eye;      // in cells
flat out vec3 v_reach;    // of a distance in cells: towards the far colour; start and speed of the fading
flat out vec3 v_near;
flat out vec3 v_far_less_near;
flat out vec3 v_line;
flat out float v_fineness;
out vec2 v_sky;
#ifdef BALL
uniform mat3 u_to_ball;
uniform vec3 u_ball_center, u_light, u_tint;
out vec3 v_ball_ray;      // the ray in the ball's space, for a way as of v_ray
flat out vec3 v_ball_eye;
flat out vec3 v_ball_up;  // of the ray's vertical part, to be turned over in the mirror
flat out vec3 v_ball_light;
flat out vec3 v_image;
#endif

void main() {
  vec2 clip = mix(u_bounds.xy, u_bounds.zw, vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)));
  gl_Position = vec4(clip, 0.0, 1.0);
  v_sky = sky_place(clip);
  vec3 direction = (u_ray * vec4(clip, 1.0, 1.0)).xyz;
  float height = u_floor_z - u_eye.z;
  v_ray = vec3(direction.xy * u_cells, direction.z / height);
  v_eye = u_eye.xy * u_cells;
  v_reach = vec3(0.2, u_fade.x * u_cells, 1.0 / (u_fade.y - u_fade.x)) / vec3(u_cells, 1.0, u_cells);
  v_near = u_near;
  v_far_less_near = u_far - u_near;
  v_line = u_line;
  v_fineness = u_fineness;
#ifdef BALL
  v_ball_ray = u_to_ball * direction;
  v_ball_eye = u_to_ball * (u_eye - u_ball_center);
  v_ball_up = u_to_ball[2] * (2.0 * height);
  v_ball_light = normalize(u_to_ball * u_light);
  v_image = u_tint;
#endif
}
