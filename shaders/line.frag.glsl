// Anti-aliased line with an optional darker casing that makes it readable on light and dark.
uniform vec4 paint;
uniform vec4 casing;
uniform float half_width;  // with the casing
uniform float core_width;  // half, without it
uniform bool by_value;
uniform vec4 range;        // pivot, its place in the table, and slopes below and above it
uniform sampler1D table;
uniform vec4 undefined_color;  // alpha 0: left out
uniform float dash;        // DASHED: length of a dash with its gap, in the unit of the curve
uniform float dash_share;  // share of it that is painted

noperspective in float side;
noperspective in vec2 map_value;
out vec4 color;

float table_place(float value) {
  return clamp(range.y + (value - range.x) * (value < range.x ? range.z : range.w), 0.0, 1.0);
}

void main() {
  float d = abs(side);
  vec4 inner = paint;
  float shown = 1.0;
  if (by_value) {
    shown = map_value.y < 0.5 ? undefined_color.a : 1.0;
    inner.rgb = map_value.y < 0.5
                    ? undefined_color.rgb
                    : texture(table, table_place(map_value.x) * (255.0 / 256.0) + 0.5 / 256.0).rgb;
  }
  float core = clamp(core_width + 0.5 - d, 0.0, 1.0) * inner.a * shown;
  float all = clamp(half_width + 0.5 - d, 0.0, 1.0) * casing.a * shown;
#if DASHED
  float place = map_value.x / dash, per_pixel = max(fwidth(place), 1e-6);
  float in_dash = clamp((0.5 * dash_share - abs(fract(place) - 0.5)) / per_pixel + 0.5, 0.0, 1.0);
  core *= in_dash;
  all *= in_dash;
#endif
  float alpha = core + all * (1.0 - core);
  if (alpha < 0.003) discard;
  color = vec4((inner.rgb * core + casing.rgb * all * (1.0 - core)) / alpha, alpha);
}
