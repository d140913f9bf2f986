// Anti-aliased line with an optional darker casing that makes it readable on light and dark.
uniform vec4 paint;
uniform vec4 casing;
uniform float half_width;  // with the casing
uniform float core_width;  // half, without it
uniform bool by_value;
uniform vec2 range;
uniform sampler1D table;
uniform vec3 undefined_color;

noperspective in float side;
noperspective in vec2 map_value;
out vec4 color;

void main() {
  float d = abs(side);
  vec4 inner = paint;
  if (by_value)
    inner.rgb = map_value.y < 0.5
                    ? undefined_color
                    : texture(table, clamp((map_value.x - range.x) * range.y, 0.0, 1.0) * (255.0 / 256.0) + 0.5 / 256.0).rgb;
  float core = clamp(core_width + 0.5 - d, 0.0, 1.0) * inner.a;
  float all = clamp(half_width + 0.5 - d, 0.0, 1.0) * casing.a;
  float alpha = core + all * (1.0 - core);
  if (alpha < 0.003) discard;
  color = vec4((inner.rgb * core + casing.rgb * all * (1.0 - core)) / alpha, alpha);
}
