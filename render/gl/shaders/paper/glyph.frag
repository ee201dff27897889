// SPDX-License-Identifier: MIT
// Ink where the mask says. Colours are mixed as they are stored, where light ink thins out: the gain makes up for it.
uniform sampler2D u_atlas;
in vec2 v_texel;
flat in vec4 v_color;
flat in float v_gain;
out vec4 o_color;
void main() {
  float covered = texelFetch(u_atlas, ivec2(v_texel), 0).r;
  o_color = v_color * (covered + v_gain * covered * (1.0 - covered));
}
