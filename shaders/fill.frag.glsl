uniform vec4 paint;
out vec4 color;

void main() { color = paint; }
