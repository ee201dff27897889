#version 330 core
uniform sampler2D u_mask;  // r: ink, g: halo
in vec2 v_local;
flat in vec4 v_ink;
flat in vec4 v_halo;
out vec4 o_color;
void main() {
  vec2 mask = texelFetch(u_mask, ivec2(v_local), 0).rg;
  float halo = mask.g * v_halo.a;
  float ink = mask.r * v_ink.a;
  vec4 under = vec4(v_halo.rgb, 1.0) * halo;
  o_color = under * (1.0 - ink) + vec4(v_ink.rgb, 1.0) * ink;
}
