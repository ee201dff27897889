// SPDX-License-Identifier: MIT
// A glass ellipsoid with nothing in it, or (FAR_SIDE, NEAR_SIDE) one of its sides; the near one with its depth.
noperspective in vec3 v_ray;
noperspective in vec3 v_towards;
noperspective in float v_to_light;
flat in vec3 v_eye;
flat in vec3 v_per_axis;
flat in vec3 v_up;
flat in vec3 v_light;
flat in vec3 v_tint;
flat in vec2 v_graticule_fineness;
#ifdef NEAR_SIDE
uniform mat4 u_view_projection;
uniform vec3 u_eye;
#endif
out vec4 o_color;

/// 1 / each, by one division.
vec3 reciprocals(vec3 x) {
  vec3 others = x.yzx * x.zxy;
  return others * (1.0 / (x.x * others.x));
}

void main() {
  Glass glass = Glass(v_eye, v_per_axis, v_up, v_light, v_tint, v_graticule_fineness.x);
  float fineness = v_graticule_fineness.y;
  Ray ray = Ray(v_towards, 0.0, 0.0);
  Chord chord = chord_of(glass, ray);
  vec3 near = near_point(glass, chord, ray), far = far_point(glass, chord, ray);
  vec3 near_normal = normal_at(glass, near), far_normal = normal_at(glass, far);
  vec3 per_length = reciprocals(sqrt(vec3(dot(near_normal, near_normal), dot(far_normal, far_normal), dot(v_ray, v_ray))));
  ray.per_length = per_length.z;
  ray.to_light = v_to_light * per_length.z;
#if defined(FAR_SIDE)
  o_color = far_side(glass, chord, ray, far, per_length.y, fineness);
#elif defined(NEAR_SIDE)
  o_color = near_side(glass, chord, ray, near, per_length.x, fineness);
  if (chord.coverage <= 0.0) discard;
  vec4 clip = u_view_projection * vec4(u_eye + (chord.middle - chord.half_length) * v_ray, 1.0);
  gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0);
#else
  vec4 front = near_side(glass, chord, ray, near, per_length.x, fineness);
  o_color = front + (1.0 - front.a) * far_side(glass, chord, ray, far, per_length.y, fineness);
#endif
}
