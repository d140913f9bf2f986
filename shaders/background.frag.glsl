uniform vec3 top;
uniform vec3 bottom;
in float height;
out vec4 color;

void main() { color = vec4(mix(bottom, top, clamp(height, 0.0, 1.0)) + dither(), 1.0); }
