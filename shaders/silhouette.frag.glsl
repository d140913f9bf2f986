// Borders of the areas of a mask, outside of what they enclose. Red of the mask names an object (0: none), green says
// that it is only hovered.
uniform sampler2D mask;
uniform float width;  // pixels
uniform vec4 selected_paint, hovered_paint, casing;
out vec4 color;

ivec2 last;
vec2 at(ivec2 pixel) { return texelFetch(mask, clamp(pixel, ivec2(0), last), 0).rg; }

void main() {
  last = textureSize(mask, 0) - 1;
  ivec2 here = ivec2(gl_FragCoord.xy);
  vec2 own = at(here);
  int reach = int(ceil(width)) + 2;
  // Far from every border all of these are alike, and the search below is left at once.
  bool apart = false;
  for (int k = 0; k < 8; ++k) {
    ivec2 way = ivec2((k & 1) * 2 - 1, (k & 2) - 1) * reach;
    if (k >= 4) way = k == 4 ? ivec2(reach, 0) : k == 5 ? ivec2(-reach, 0) : k == 6 ? ivec2(0, reach) : ivec2(0, -reach);
    apart = apart || at(here + way).r != own.r;
  }
  int search = apart ? reach : 0;
  float nearest = 1e6, green = 0.0;
  for (int j = -search; j <= search; ++j)
    for (int i = -search; i <= search; ++i) {
      vec2 other = at(here + ivec2(i, j));
      float d = length(vec2(i, j));
      if (other.r > own.r && d < nearest) { nearest = d; green = other.g; }
    }
  float line = clamp(width + 0.5 - nearest, 0.0, 1.0), rim = clamp(width + 1.5 - nearest, 0.0, 1.0) * casing.a;
  vec4 paint = green > 0.5 ? hovered_paint : selected_paint;
  float alpha = line * paint.a + rim * (1.0 - line);
  if (alpha < 0.003) discard;
  color = vec4(mix(casing.rgb, paint.rgb, line), alpha);
}
