// SPDX-License-Identifier: MIT
// A piece of a tube, lit as a cylinder, with the part of the pixel that it covers, behind the glass where it is.
flat in vec4 v_color;
in vec4 v_light;  // as stroke.vert gives them
in vec4 v_px;     // across, half width, to the nearer end, above the level below which it is fainter, or not drawn
in vec2 v_bow;
in vec2 v_dash;   // dashes; pixels to a dash and a gap
#if GLASSES > 0
#ifdef GL_ES
uniform Glass u_glass[GLASSES];
#define v_glass u_glass
#else
flat in Glass v_glass[GLASSES];
#endif
in vec3 v_towards[GLASSES];
flat in vec3 v_towards_bow[GLASSES];
in vec2 v_ray;
#endif
uniform vec2 u_strengths;  // below that level and above
out vec4 o_color;

/// How much of a pixel is covered by what reaches so far beyond its middle.
float reached(float px) { return clamp(px + 0.5, 0.0, 1.0); }

void main() {
  float bowed = v_bow.x * (1.0 - v_bow.x), beside = v_px.x - bowed * v_bow.y;
  float across = clamp(beside / v_px.y, -1.0, 1.0), offset = abs(beside);
  float front = sqrt(1.0 - across * across);
  float to_light = across * v_light.x + front * v_light.y;
  vec3 color = lit(v_color.rgb, to_light, (to_light + front * v_light.z) * v_light.w, 0.58, 0.32);
#if GLASSES > 0
  for (int i = 0; i < GLASSES; ++i)
    color = behind_glass(color, v_glass[i], Ray(v_towards[i] + bowed * v_towards_bow[i], v_ray.x, v_ray.y));
#endif

  float covered = clamp(min(v_px.y, offset + 0.5) - max(-v_px.y, offset - 0.5), 0.0, 1.0);
  float gap = abs(fract(v_dash.x + 0.25) - 0.5);  // 0 in the middle of a dash, 1/2 of a gap
  float alpha = v_color.a * covered * reached(v_px.z) * reached((0.25 - gap) * v_dash.y) *
                mix(u_strengths.x, u_strengths.y, reached(v_px.w));
  o_color = vec4(color, 1.0) * alpha;
}
