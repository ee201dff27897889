// SPDX-License-Identifier: MIT
// Averages squares of pixels of a premultiplied picture into one each.
uniform sampler2D u_fine;
uniform int u_fineness;  // pixels to a side
out vec4 o_color;
void main() {
  ivec2 corner = ivec2(gl_FragCoord.xy) * u_fineness;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < u_fineness; ++y)
    for (int x = 0; x < u_fineness; ++x) sum += texelFetch(u_fine, corner + ivec2(x, y), 0);
  o_color = sum / float(u_fineness * u_fineness);
}
