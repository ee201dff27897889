// What lies behind the near sides of the glass ellipsoids, of which there are GLASSES. They are laid over each thing by
// itself and not over the picture: laying over is affine, so things that cover one another partly come out the same.
#if GLASSES > 0
uniform Glass u_glass[GLASSES];
uniform mat3 u_to_ball[GLASSES];
uniform float u_fineness;  // of pixels to a side that are averaged into one: lines keep their width
#endif

/// @param color of a thing where the ray ends. @param ray from the eye, view's frame
vec3 behind_glass(vec3 color, vec3 ray) {
#if GLASSES > 0
  float per_length = inversesqrt(dot(ray, ray));
  float to_light = dot(ray, u_light) * per_length;
  for (int i = 0; i < GLASSES; ++i) {
    Ray through = Ray(u_to_ball[i] * ray, per_length, to_light);
    Chord chord = chord_of(u_glass[i], through);
    float depth = 1.0 - (chord.middle - chord.half_length);
    // What lies on the glass is in front of it: the soft edge begins behind.
    float behind = clamp(depth / max(fwidth(depth), 1e-6), 0.0, 1.0);
    vec4 side = behind * near_side(u_glass[i], chord, through, u_fineness);
    color = side.rgb + (1.0 - side.a) * color;
  }
#endif
  return color;
}
