// SPDX-License-Identifier: MIT
// The studio with nothing in it.
noperspective in vec2 v_sky;
noperspective in vec2 v_place;
out vec4 o_color;
void main() { o_color = vec4(studio(v_sky) + noise(v_place), 1.0); }
