// The floor: grid, soft shadow, contact darkening and a faint mirror image of the ellipsoid, all in closed form in the
// space where the ellipsoid is the unit ball. Fades with distance. Output is premultiplied.
#version 330 core
in vec2 v_clip;
uniform mat4 u_ray;              // clip (x, y, 1, 1) -> direction in the view frame, not normalised
uniform vec3 u_eye;
uniform float u_floor_z;
uniform float u_grid;
uniform float u_ball;            // 1: there is an ellipsoid
uniform mat3 u_to_ball;
uniform vec3 u_ball_center;      // view frame
uniform vec3 u_light;            // unit, towards the key light
uniform vec3 u_tint;
uniform vec3 u_near, u_far;      // its colour below the body, and further out
uniform vec3 u_line;             // of the grid
uniform float u_fineness;        // of pixels to a side that are averaged into one: lines keep their width
out vec4 o_color;

const float kFadeStart = 1.6, kFadeEnd = 7.5;

// Both families of lines at every integer, anti-aliased, fainter where they crowd.
float grid(vec2 p, vec2 w, float width_px) {
  vec2 d = abs(fract(p - 0.5) - 0.5) / w;
  vec2 lines = clamp(0.5 * width_px + 0.5 - d, 0.0, 1.0) * clamp(0.35 / w - 0.35, 0.0, 1.0);
  return max(lines.x, lines.y);
}

void main() {
  vec3 direction = (u_ray * vec4(v_clip, 1.0, 1.0)).xyz;
  float way = (u_floor_z - u_eye.z) / direction.z;
  vec3 point = u_eye + way * direction;
  float reach = length(point.xy);
  vec2 cells = point.xy / u_grid;
  vec2 w = max(u_fineness * fwidth(cells), 1e-6);
  float lines = max(0.30 * grid(4.0 * cells, 4.0 * w, 1.0), 0.62 * grid(cells, w, 1.5));
  vec3 color = mix(u_near, u_far, clamp(0.2 * reach, 0.0, 1.0));
  color = mix(color, u_line, lines);

  vec3 p = u_to_ball * (point - u_ball_center);
  float p2 = dot(p, p);
  // Mirror: how close the reflected ray passes the ball's centre.
  vec3 d = u_to_ball * vec3(direction.xy, -direction.z);
  float dd = dot(d, d), along = -dot(p, d);
  float miss2 = p2 - along * along / dd;
  float image = clamp((1.0 - miss2) / max(fwidth(miss2), 1e-4) + 0.5, 0.0, 1.0) * step(0.0, along) *
                exp(-0.9 * max(along, 0.0) * inversesqrt(dd));
  color = mix(color, 0.92 * u_tint, 0.22 * image * u_ball);
  // Shadow: how close the ray to the light passes it, blurred with the way it has come.
  vec3 l = normalize(u_to_ball * u_light);
  float to_light = -dot(p, l);
  float blur = 0.16 + 0.16 * max(to_light, 0.0);
  float shadow = 1.0 - smoothstep(1.0 - blur, 1.0 + blur, sqrt(max(p2 - to_light * to_light, 0.0)));
  // Contact: the part of the sky that the ball hides.
  float contact = clamp(1.0 / (p2 * p2), 0.0, 1.0);
  color *= vec3(1.0) - u_ball * min(0.30 * shadow + 0.22 * contact, 0.45) * vec3(1.0, 0.96, 0.90);

  vec2 pixel = floor(gl_FragCoord.xy / u_fineness) + 0.5;
  vec2 cell = vec2(floor(pixel.x / 16.0) * 7.0, pixel.y);  // as in backdrop.frag
  float noise = fract(52.9829189 * fract(dot(cell, vec2(0.06711056, 0.00583715)))) - 0.5;
  float alpha = way > 0.0 ? 1.0 - smoothstep(kFadeStart, kFadeEnd, reach) : 0.0;
  o_color = vec4(color + noise / 255.0, 1.0) * alpha;
}
