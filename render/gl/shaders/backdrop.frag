// Backdrop and floor in one pass. Output is premultiplied.
#version 330 core
uniform vec2 u_viewport_origin;  // px
uniform vec2 u_viewport_size;    // px
uniform mat4 u_ray;              // clip (x, y, 1, 1) -> direction in the view frame, not normalised
uniform vec3 u_eye;
uniform vec4 u_sky;              // flat colour, premultiplied
uniform float u_studio;          // 1: gradient instead of the flat colour
uniform float u_floor;           // 1: there is a floor
uniform float u_floor_z;
uniform float u_grid;
uniform mat3 u_to_ball;          // view frame -> the space where the ellipsoid is the unit ball
uniform vec3 u_ball_center;      // of the ellipsoid, view frame
uniform float u_shadow;          // 1: the ellipsoid throws a shadow
uniform vec3 u_light;            // unit, towards the key light
uniform vec3 u_tint;
out vec4 o_color;

const float kFadeStart = 1.6, kFadeEnd = 7.5;

// A fixed 8x8 ordered pattern, half a level either way: keeps the gradient from banding, the same every time.
float dither(ivec2 p) {
  int x = p.x ^ p.y, y = p.y;
  int v = ((x & 1) << 5) | ((y & 1) << 4) | ((x & 2) << 2) | ((y & 2) << 1) | ((x & 4) >> 1) | ((y & 4) >> 2);
  return (float(v) + 0.5) / 64.0 - 0.5;
}

vec3 studio(vec2 p) {  // p: 0..1 from the lower left
  vec2 d = (p - vec2(0.5, 0.62)) * vec2(1.25, 1.0);
  float r = dot(d, d);
  vec3 c = mix(vec3(0.945, 0.949, 0.953), vec3(0.735, 0.765, 0.795), clamp(r * 1.25, 0.0, 1.0));
  return c;
}

float line(float coordinate, float width_px) {  // anti-aliased line at every integer
  float w = fwidth(coordinate);
  float d = abs(fract(coordinate - 0.5) - 0.5) / max(w, 1e-6);
  return clamp(0.5 * width_px + 0.5 - d, 0.0, 1.0) * clamp(0.35 / max(w, 1e-6) - 0.35, 0.0, 1.0);
}

float grid(vec2 p, float width_px) { return max(line(p.x, width_px), line(p.y, width_px)); }

// Soft shadow of the unit ball: how close the ray to the light passes the centre, blurred with the way it has come.
float shadow(vec3 point) {
  vec3 p = u_to_ball * (point - u_ball_center);
  vec3 d = normalize(u_to_ball * u_light);
  float along = -dot(p, d);
  float miss = length(p + along * d);
  float blur = 0.16 + 0.16 * max(along, 0.0);
  return 1.0 - smoothstep(1.0 - blur, 1.0 + blur, miss);
}

// Darkening where the floor comes near the ball: the part of the sky that the ball hides.
float contact(vec3 point) {
  vec3 p = u_to_ball * (point - u_ball_center);
  float r2 = dot(p, p);
  return clamp(1.0 / (r2 * r2), 0.0, 1.0);
}

// Mirror image of the glass: where the reflected ray meets the ball, and how steeply.
float mirror(vec3 point, vec3 direction) {
  vec3 p = u_to_ball * (point - u_ball_center);
  vec3 d = normalize(u_to_ball * reflect(direction, vec3(0.0, 0.0, 1.0)));
  float along = -dot(p, d);
  float miss = length(p + along * d);
  float w = max(fwidth(miss), 1e-4);
  return clamp((1.0 - miss) / w + 0.5, 0.0, 1.0) * step(0.0, along) * (0.35 + 0.65 * miss * miss);
}

void main() {
  vec2 p = (gl_FragCoord.xy - u_viewport_origin) / u_viewport_size;
  vec3 backdrop = studio(p);
  vec4 color = mix(u_sky, vec4(backdrop, 1.0), u_studio);

  if (u_floor > 0.5) {
    vec3 direction = (u_ray * vec4(2.0 * p - 1.0, 1.0, 1.0)).xyz;
    float way = (u_floor_z - u_eye.z) / direction.z;
    vec3 point = u_eye + way * direction;
    float reach = length(point.xy);
    vec2 cells = point.xy / u_grid;
    float fine = grid(cells * 4.0, 1.0), bold = grid(cells, 1.5);
    if (way > 0.0 && reach < kFadeEnd) {
      float presence = 1.0 - smoothstep(kFadeStart, kFadeEnd, reach);
      vec3 floor_color = mix(vec3(0.800, 0.830, 0.865), vec3(0.86, 0.88, 0.905), clamp(reach / 5.0, 0.0, 1.0));
      floor_color = mix(floor_color, vec3(0.60, 0.66, 0.72), max(0.30 * fine, 0.62 * bold));
      if (u_shadow > 0.5) {
        floor_color = mix(floor_color, u_tint * 0.92, 0.16 * mirror(point, direction));
        float dark = 0.36 * shadow(point) + 0.30 * contact(point);
        floor_color *= vec3(1.0) - min(dark, 0.62) * vec3(1.0, 0.96, 0.90);
      }
      float opacity = presence;
      color = mix(color, vec4(floor_color, 1.0), opacity);
    }
  }
  color.rgb += dither(ivec2(gl_FragCoord.xy)) / 255.0 * color.a;
  o_color = color;
}
