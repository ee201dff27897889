// SPDX-License-Identifier: MIT
// A glass ellipsoid as the shaders get it.
struct Glass {
  vec3 eye;       // in the ball's space, as all but the tint
  vec3 per_axis;  // 1 / semi-axes
  vec3 up;        // what a product with a point of the ball turns into the height of the normal there, ...
  vec3 light;     // ... or into its share of the direction to the key light
  vec3 tint;
  float graticule;
};
