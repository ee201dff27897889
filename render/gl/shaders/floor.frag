// The floor: grid, and (BALL) soft shadow, contact darkening and (MIRROR) a faint image of the ellipsoid, all in closed
// form in the space where this is the unit ball. Fades with distance into the sky; FROM_BELOW it is a sheet to look
// through, laid over what is there. Output is premultiplied.
in vec3 v_ray;
flat in vec2 v_eye;
flat in vec3 v_reach;
flat in vec3 v_near;
flat in vec3 v_far_less_near;
flat in vec3 v_line;
flat in float v_fineness;  // of pixels to a side that are averaged into one: lines keep their width
in vec2 v_sky;
#ifdef BALL
in vec3 v_ball_ray;
flat in vec3 v_ball_eye;
flat in vec3 v_ball_up;
flat in vec3 v_ball_light;
flat in vec3 v_image;
#endif
out vec4 o_color;

// Both families of lines at every integer, anti-aliased, fainter where they crowd. @param sharp pixels to a cell
vec2 grid(vec2 cells, vec2 sharp, float width_px) {
  vec2 d = abs(cells - floor(cells + 0.5)) * sharp;
  return clamp(0.5 * width_px + 0.5 - d, 0.0, 1.0) * clamp(0.35 * sharp - 0.35, 0.0, 1.0);
}

#ifdef BALL
vec3 with_ball(vec3 color, float way) {
  vec3 p = v_ball_eye + way * v_ball_ray;
  float p2 = dot(p, p);
#ifdef MIRROR
  // How close the reflected ray passes the ball's centre.
  vec3 d = v_ball_ray - v_ray.z * v_ball_up;
  float along = -dot(p, d) * inversesqrt(dot(d, d));
  float miss2 = p2 - along * along;
  float image = clamp((1.0 - miss2) / max(fwidth(miss2), 1e-4) + 0.5, 0.0, 1.0) * step(0.0, along) *
                exp2(-1.2984255 * along);
  color = mix(color, v_image, 0.22 * image);
#endif
  // Shadow: how close the ray to the light passes it, blurred with the way it has come.
  float to_light = -dot(p, v_ball_light);
  float blur = 0.16 + 0.16 * max(to_light, 0.0);
  float shadow = clamp(0.5 + 0.5 * (1.0 - sqrt(max(p2 - to_light * to_light, 0.0))) / blur, 0.0, 1.0);
  shadow *= shadow * (3.0 - 2.0 * shadow);
  // Contact: the part of the sky that the ball hides.
  float contact = min(1.0 / (p2 * p2), 1.0);
  return color * (vec3(1.0) - min(0.30 * shadow + 0.22 * contact, 0.45) * vec3(1.0, 0.96, 0.90));
}
#endif

void main() {
  float way = 1.0 / v_ray.z;
  vec2 cells = v_eye + way * v_ray.xy;
  vec2 sharp = 1.0 / (v_fineness * fwidth(cells));
  vec2 both = max(0.30 * grid(4.0 * cells, 0.25 * sharp, 1.0), 0.62 * grid(cells, sharp, 1.5));
  float reach = length(cells);
  vec3 color = v_near + min(v_reach.x * reach, 1.0) * v_far_less_near;
  float lines = max(both.x, both.y);
  color += lines * (v_line - color);
#ifdef BALL
  color = with_ball(color, way);
#endif
  float faded = clamp((reach - v_reach.y) * v_reach.z, 0.0, 1.0);
  float alpha = way > 0.0 ? 1.0 - faded * faded * (3.0 - 2.0 * faded) : 0.0;
  vec3 grain = noise(v_fineness);
#if defined(FROM_BELOW)
  alpha *= 0.42 + 0.4 * lines;
  o_color = vec4(color + grain, 1.0) * alpha;
#elif defined(STUDIO)
  vec3 behind = studio(v_sky);
  o_color = vec4(behind + alpha * (color - behind) + grain, 1.0);
#else
  o_color = mix(u_sky, vec4(color + grain, 1.0), alpha);
#endif
}
