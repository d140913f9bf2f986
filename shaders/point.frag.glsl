uniform vec4 paint;
uniform vec4 casing;
uniform float radius;
uniform float core_radius;
uniform int shape;  // 0 disc, 1 square, 2 ring, 3 diamond, 4 triangle
noperspective in vec2 offset;
#if COLORED
flat in vec4 own_paint;  // alpha 0 where the common paint holds
#endif
out vec4 color;

// Distance from the middle, so that the outline lies at `radius`.
float reach() {
  vec2 p = abs(offset);
  if (shape == 1) return max(p.x, p.y) * 1.12;
  if (shape == 3) return (p.x + p.y) * 0.80;
  if (shape == 4) return max(0.866 * p.x + 0.5 * offset.y, -offset.y) * 1.45;
  return length(offset);
}

void main() {
  float d = reach();
  vec4 inner = paint;
#if COLORED
  if (own_paint.a > 0.0) inner.rgb = own_paint.rgb;
#endif
  float core = clamp(core_radius + 0.5 - d, 0.0, 1.0) * inner.a;
  float all = clamp(radius + 0.5 - d, 0.0, 1.0) * casing.a;
  if (shape == 2) {
    float hole = clamp(d - 0.52 * core_radius + 0.5, 0.0, 1.0);
    core *= hole;
    all *= clamp(d - 0.30 * core_radius + 0.5, 0.0, 1.0);
  }
  float alpha = core + all * (1.0 - core);
  if (alpha < 0.003) discard;
  color = vec4((inner.rgb * core + casing.rgb * all * (1.0 - core)) / alpha, alpha);
}
