// SPDX-License-Identifier: MIT
// Lays a premultiplied layer over what is there.
uniform sampler2D u_layer;
uniform vec2 u_corner;  // of the layer, px
out vec4 o_color;
void main() { o_color = texelFetch(u_layer, ivec2(gl_FragCoord.xy - u_corner), 0); }
