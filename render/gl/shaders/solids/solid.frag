// SPDX-License-Identifier: MIT
// A ball, or (CONE) one or two cones, ray-cast 8 times in each pixel, no two in one row or column of an 8 x 8 grid.
flat in vec3 v_from;
flat in vec3 v_to;
flat in vec4 v_color;
flat in vec2 v_shape;  // radius; height of a cone
in vec3 v_ray;  // from the eye to a point in the plane of the rectangle
uniform mat4 u_view_projection;
uniform vec3 u_eye;
uniform vec3 u_light;          // unit, towards the key light
#if GLASSES > 0
uniform Glass u_glass[GLASSES];
uniform mat3 u_to_ball[GLASSES];
#endif
uniform float u_level;        // height below which things are fainter, or not drawn
uniform float u_least;        // what hides no more of the pixel is not drawn
uniform vec2 u_strengths;      // below that level and above
out vec4 o_color;

struct Hit {
  float way;  // along the ray; < 0: none
  vec3 normal;
};

#ifdef CONE
/// @param x unit, from the tip to the base
Hit hit_cone(vec3 from, vec3 d, vec3 tip, vec3 x) {
  float height = v_shape.y, radius = v_shape.x;
  float start = dot(tip - from, d);  // near the cone: digits
  vec3 v = from + start * d - tip;
  float slope = radius / height, k = 1.0 + slope * slope;
  float dx = dot(d, x), vx = dot(v, x);
  Hit found = Hit(-1.0, d);
  float to_base = (height - vx) / dx;
  vec3 on_base = v + to_base * d - height * x;
  if (dot(on_base, on_base) < radius * radius) found = Hit(start + to_base, x);
  float a = 1.0 - k * dx * dx, b = dot(v, d) - k * vx * dx, c = dot(v, v) - k * vx * vx;
  float discriminant = b * b - a * c;
  if (discriminant > 0.0) {
    float root = sqrt(discriminant);
    for (int i = 0; i < 2; ++i) {
      float t = (-b + (i == 0 ? root : -root)) / a;
      float along = vx + t * dx;
      if (along > 0.0 && along < height && (found.way < 0.0 || start + t < found.way))
        found = Hit(start + t, normalize(v + t * d - k * along * x));
    }
  }
  return found;
}

Hit hit(vec3 from, vec3 d) {
  vec3 x = normalize(v_from - v_to);
  Hit first = hit_cone(from, d, v_to, x), second = hit_cone(from, d, v_from - v_shape.y * x, x);
  if (first.way < 0.0 || (second.way > 0.0 && second.way < first.way)) return second;  // GLSL ES chooses no structs by ?:
  return first;
}
#else
Hit hit(vec3 from, vec3 d) {
  float middle = dot(v_from - from, d);
  vec3 nearest = from + middle * d - v_from;
  float left = v_shape.x * v_shape.x - dot(nearest, nearest);
  if (left <= 0.0) return Hit(-1.0, d);
  float way = middle - sqrt(left);
  return Hit(way, (from + way * d - v_from) / v_shape.x);
}
#endif

void main() {
  vec3 right = dFdx(v_ray), up = dFdy(v_ray);
  vec3 sum = vec3(0.0);
  float weights = 0.0, ways = 0.0, alphas = 0.0;
  for (int i = 0; i < 8; ++i) {
    vec2 offset = (vec2(float(i), float((3 * i + 1) % 8)) - 3.5) / 8.0;
    vec3 d = normalize(v_ray + offset.x * right + offset.y * up);
    Hit h = hit(u_eye, d);
    float z = u_eye.z + h.way * d.z;
    float weight = h.way > 0.0 ? 1.0 : 0.0;
    sum += weight * lit(v_color.rgb, h.normal * -sign(dot(h.normal, d)), u_light, -d, 0.56, 0.18);
    weights += weight;
    ways += weight * h.way;
    alphas += weight * (z < u_level ? u_strengths.x : u_strengths.y);
  }
  // Where nothing is hit, the way is that of its surroundings: neighbours take differences with it.
  vec3 ray = weights > 0.0 ? (ways / weights) * normalize(v_ray) : v_ray;
  vec3 color = sum / max(weights, 1.0);
#if GLASSES > 0
  float per_length = inversesqrt(dot(ray, ray));
  for (int i = 0; i < GLASSES; ++i)
    color = behind_glass(color, u_glass[i], Ray(u_to_ball[i] * ray, per_length, dot(ray, u_light) * per_length));
#endif
  if (v_color.a * weights / 8.0 <= u_least || alphas <= 0.0) discard;  // and leave no depth
  vec4 clip = u_view_projection * vec4(u_eye + ray, 1.0);
  gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0);
  o_color = vec4(color, 1.0) * (v_color.a * alphas / 8.0);
}
