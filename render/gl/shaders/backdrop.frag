// The studio with nothing in it.
in vec2 v_sky;
flat in float v_fineness;
out vec4 o_color;
void main() { o_color = vec4(studio(v_sky) + noise(v_fineness), 1.0); }
