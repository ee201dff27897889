// SPDX-License-Identifier: MIT
// Glass ellipsoids, ray-cast in the space where each is the unit ball. Colours are premultiplied. Rays have any length;
// ways along them count in it.
struct Ray {
  vec3 towards;      // in the ball's space
  float per_length;  // 1 / length in the view's frame
  float to_light;    // cosine of the angle with the key light
};

/// Where a ray crosses the ball: after middle -/+ half_length.
struct Chord {
  float middle, half_length;
  float square;    // of the ray's length in the ball's space
  float coverage;  // of the pixel by the ball
};

Chord chord_of(Glass glass, Ray ray) {
  float square = dot(ray.towards, ray.towards), per_square = 1.0 / square;
  float middle = -dot(glass.eye, ray.towards) * per_square;
  vec3 nearest = glass.eye + middle * ray.towards;
  float miss2 = dot(nearest, nearest), miss = sqrt(miss2);
  float coverage = clamp((1.0 - miss) / fwidth(miss) + 0.5, 0.0, 1.0);
  return Chord(middle, sqrt(max(1.0 - miss2, 0.0) * per_square), square, coverage);
}

/// Thin circles every 30 degrees of latitude about axis 3, fainter where they crowd. @param height on that axis
float circles(float height, float fineness) {
  float z = abs(height);
  float per_width = 1.0 / max(fineness * fwidth(height), 1e-5);
  float d = min(z, min(abs(z - 0.5), abs(z - 0.8660254)));
  float crowd = 0.2617994 * sqrt(max(1.0 - z * z, 1e-4)) * per_width;
  return clamp(1.1 - d * per_width, 0.0, 1.0) * clamp(crowd - 1.0, 0.0, 1.0);
}

/// The normal there as the point on the ball has it, of any length.
vec3 normal_at(Glass glass, vec3 ball) { return ball * glass.per_axis; }

/// What both sides share. @param ball the point, on the unit ball @param per_normal 1 / length of the normal there
struct Side {
  vec3 ball;
  float per_normal;
  float facing;  // cosine of the angle of sight
  float fresnel;
  vec3 color;
};

Side side_at(Glass glass, Chord chord, Ray ray, vec3 ball, float per_normal) {
  float facing = chord.half_length * chord.square * per_normal * ray.per_length;
  float f = 1.0 - facing;
  float fresnel = f * f * f * (0.35 + 0.65 * f * f);
  float shade = (0.80 + 0.20 * max(dot(ball, glass.up) * per_normal, 0.0)) * (1.0 - 0.28 * fresnel);
  return Side(ball, per_normal, facing, fresnel, shade * glass.tint);
}

vec4 with_circles(Glass glass, Side side, float alpha, float strength, float fineness) {
  float line = min(strength * glass.graticule * circles(side.ball.z, fineness), 1.0 - alpha);
  return vec4(alpha * side.color + line * vec3(0.25, 0.38, 0.46), alpha + line);
}

vec3 near_point(Glass glass, Chord chord, Ray ray) {
  return glass.eye + (chord.middle - chord.half_length) * ray.towards;
}
vec3 far_point(Glass glass, Chord chord, Ray ray) {
  return glass.eye + (chord.middle + chord.half_length) * ray.towards;
}

vec4 far_side(Glass glass, Chord chord, Ray ray, vec3 ball, float per_normal, float fineness) {
  Side side = side_at(glass, chord, ray, ball, per_normal);
  float ahead = step(0.0, chord.middle + chord.half_length);
  return with_circles(glass, side, 0.11 + 0.25 * side.fresnel, 0.12, fineness) * (chord.coverage * ahead);
}

vec4 near_side(Glass glass, Chord chord, Ray ray, vec3 ball, float per_normal, float fineness) {
  Side side = side_at(glass, chord, ray, ball, per_normal);
  // The normal's share of the direction halfway between light and viewer; its square.
  float s = max(dot(ball, glass.light) * per_normal + side.facing, 0.0);
  float s2 = s * s / max(2.0 - 2.0 * ray.to_light, 1e-6);
  float s4 = s2 * s2;
  float s16 = s4 * s4; s16 *= s16;
  float s64 = s16 * s16; s64 *= s64;
  float highlight = 0.42 * s64 * s64 + 0.06 * s16;
  side.color += highlight * (vec3(1.0) - side.color);
  float alpha = 0.17 + 0.60 * side.fresnel;
  alpha += (1.0 - alpha) * highlight;
  float ahead = step(0.0, chord.middle - chord.half_length);  // not of an eye inside
  return with_circles(glass, side, alpha, 0.20, fineness) * (chord.coverage * ahead);
}
