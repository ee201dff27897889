// SPDX-License-Identifier: MIT
// The floor: grid, and (BALL) soft shadow, contact darkening and (MIRROR) a faint image of the ellipsoid, all in closed
// form in the space where this is the unit ball. Fades with distance into the sky; FROM_BELOW it is a sheet to look
// through, laid over what is there. Output is premultiplied. Derivatives are by formula: those of the software
// rasteriser cost more.
noperspective in vec3 v_floor;
flat in vec3 v_right;
flat in vec3 v_up;
flat in vec3 v_reach;
flat in vec3 v_near;
flat in vec3 v_far_less_near;
flat in vec3 v_line;
noperspective in vec2 v_place;
#ifdef STUDIO
noperspective in vec2 v_sky;
#else
flat in vec4 v_sky;
#endif
#ifdef BALL
noperspective in vec3 v_from_ball;
flat in float v_beside;
#endif
#ifdef MIRROR
noperspective in vec3 v_ball_ray;
flat in vec3 v_ball_eye;
flat in vec3 v_ball_up;
flat in vec3 v_image;
#endif
out vec4 o_color;

// Both families of lines at every integer, anti-aliased, fainter where they crowd. @param sharp pixels to a cell
vec2 grid(vec2 cells, vec2 sharp, float width_px) {
  vec2 d = abs(cells - roundEven(cells)) * sharp;
  return clamp(0.5 * width_px + 0.5 - d, 0.0, 1.0) * clamp(0.35 * sharp - 0.35, 0.0, 1.0);
}

#ifdef MIRROR
vec3 with_image(vec3 color, float way) {
  vec3 p = v_ball_eye + way * v_ball_ray;
  // How close the reflected ray passes the ball's centre.
  vec3 d = v_ball_ray - v_floor.z * v_ball_up;
  float along = -dot(p, d) * inversesqrt(dot(d, d));
  float miss2 = dot(p, p) - along * along;
  float image = clamp((1.0 - miss2) / max(fwidth(miss2), 1e-4) + 0.5, 0.0, 1.0) * step(0.0, along) *
                exp2(-1.2984255 * along);
  return mix(color, v_image, 0.22 * image);
}
#endif

#ifdef BALL
vec3 shaded(vec3 color, float way) {
  way = clamp(way, -1e4, 1e4);  // at the horizon, where the floor has faded: no infinity times 0
  // Of the point from the ball's centre, squared, and along the ray to the light. All roots are of homogeneous things:
  // they need not wait for the division that made `way`.
  float p2 = dot(v_from_ball.xy, v_from_ball.xy) + v_beside * v_floor.z * v_floor.z;
  float to_light = way * v_from_ball.z;
  // Shadow: how close the ray to the light passes the ball, blurred with the way it has come.
  float miss = way * sqrt(max(p2 - v_from_ball.z * v_from_ball.z, 0.0));
  float blur = 0.16 + 0.16 * max(to_light, 0.0);
  // Contact: the part of the sky that the ball hides, 1 / p2^2; for both one division.
  p2 *= way * way;
  float p4 = p2 * p2, inverse = 1.0 / (blur * p4);
  float shadow = clamp(0.5 + 0.5 * (1.0 - miss) * (p4 * inverse), 0.0, 1.0);
  shadow *= shadow * (3.0 - 2.0 * shadow);
  float contact = min(blur * inverse, 1.0);
  return color * (vec3(1.0) - min(0.30 * shadow + 0.22 * contact, 0.45) * vec3(1.0, 0.96, 0.90));
}
#endif

void main() {
  float way = 1.0 / v_floor.z;
  vec2 cells = way * v_floor.xy;
  // Of cells in a pixel, times v_floor.z: |d/dx| + |d/dy|, as fwidth has it.
  vec2 slope = abs(v_right.xy - v_right.z * cells) + abs(v_up.xy - v_up.z * cells);
  vec2 sharp = (v_floor.z / (slope.x * slope.y)) * slope.yx;
  vec2 both = max(0.30 * grid(4.0 * cells, 0.25 * sharp, 1.0), 0.62 * grid(cells, sharp, 1.5));
  float reach = way * length(v_floor.xy);
  vec3 color = v_near + min(v_reach.x * reach, 1.0) * v_far_less_near;
  float lines = max(both.x, both.y);
  color += lines * (v_line - color);
#ifdef MIRROR
  color = with_image(color, way);
#endif
#ifdef BALL
  color = shaded(color, way);
#endif
  float faded = clamp((reach - v_reach.y) * v_reach.z, 0.0, 1.0);
  float alpha = way > 0.0 ? 1.0 - faded * faded * (3.0 - 2.0 * faded) : 0.0;
  vec3 grain = noise(v_place);
#if defined(FROM_BELOW)
  alpha *= 0.42 + 0.4 * lines;
  o_color = vec4(color + grain, 1.0) * alpha;
#elif defined(STUDIO)
  vec3 behind = studio(v_sky);
  o_color = vec4(behind + alpha * (color - behind) + grain, 1.0);
#else
  o_color = mix(v_sky, vec4(color + grain, 1.0), alpha);
#endif
}
