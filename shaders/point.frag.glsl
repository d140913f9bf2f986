uniform vec4 paint;
uniform vec4 casing;
uniform float radius;
uniform float core_radius;
noperspective in vec2 offset;
out vec4 color;

void main() {
  float d = length(offset);
  float core = clamp(core_radius + 0.5 - d, 0.0, 1.0) * paint.a;
  float all = clamp(radius + 0.5 - d, 0.0, 1.0) * casing.a;
  float alpha = core + all * (1.0 - core);
  if (alpha < 0.003) discard;
  color = vec4((paint.rgb * core + casing.rgb * all * (1.0 - core)) / alpha, alpha);
}
