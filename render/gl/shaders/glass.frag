// A glass ellipsoid with nothing in it, or (FAR_SIDE, NEAR_SIDE) one of its sides; the near one with its depth.
in vec3 v_ray;
in vec3 v_towards;
in float v_to_light;
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

void main() {
  float per_length = inversesqrt(dot(v_ray, v_ray));
  Ray ray = Ray(v_towards, per_length, v_to_light * per_length);
  Glass glass = Glass(v_eye, v_per_axis, v_up, v_light, v_tint, v_graticule_fineness.x);
  float fineness = v_graticule_fineness.y;
  Chord chord = chord_of(glass, ray);
#if defined(FAR_SIDE)
  o_color = far_side(glass, chord, ray, fineness);
#elif defined(NEAR_SIDE)
  o_color = near_side(glass, chord, ray, fineness);
  if (chord.coverage <= 0.0) discard;
  vec4 clip = u_view_projection * vec4(u_eye + (chord.middle - chord.half_length) * v_ray, 1.0);
  gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0);
#else
  vec4 near = near_side(glass, chord, ray, fineness);
  o_color = near + (1.0 - near.a) * far_side(glass, chord, ray, fineness);
#endif
}
