// The surface: studio light on clay, patch colours, zebra stripes, or a colour map.
// MODE: 0 shaded, 1 patches, 2 zebra, 3 values, 4 neutral (a base for coloured curves).
uniform bool perspective;
uniform vec2 viewport;         // pixels
uniform float pixel_slope;     // slope of a view ray one pixel from the middle
uniform vec3 outside_color;    // sRGB
uniform vec3 inside_color;
uniform vec3 undefined_color;
uniform vec3 up_in_eye;        // the world's z in camera axes
uniform vec2 range;            // low, 1 / (high - low)
uniform sampler1D table;
uniform vec3 stripe_direction; // camera axes, unit
uniform float stripes;
uniform float reflection;
uniform float dimming;         // 0 .. 1
uniform vec3 selected_tint;
uniform vec3 hovered_tint;

in vec3 eye_normal;
#if MODE == 3
in vec2 map_value;  // value, and 1 where it is defined
#endif
#if MODE == 1 || HIGHLIGHTS
flat in vec4 patch_color;
#endif
out vec4 color;

// Key from the upper left, a cooler fill from the right, a rim from behind: fixed to the camera like a photographer's
// lamps, over an ambient light that is brighter from above the ground.
vec3 studio(vec3 base, vec3 n, vec3 v, bool inside) {
  const vec3 key = normalize(vec3(-0.55, 0.66, 0.50)), fill = normalize(vec3(0.75, -0.05, 0.55));
  const vec3 rim = normalize(vec3(0.25, 0.55, -0.80));
  float sky = 0.5 + 0.5 * dot(n, up_in_eye);
  vec3 light = mix(vec3(0.060, 0.058, 0.056), vec3(0.190, 0.200, 0.220), sky);
  float lit = max((dot(n, key) + 0.25) / 1.25, 0.0);
  light += 1.06 * lit * lit * vec3(1.0, 0.975, 0.94);
  light += 0.24 * max(dot(n, fill), 0.0) * vec3(0.80, 0.90, 1.0);
  vec3 result = base * light;
  float facing = max(dot(n, v), 0.0);
  float edge = pow(max(1.0 - facing, 0.0), 3.0);
  result += (inside ? 0.03 : 0.16) * edge * (0.35 + max(dot(n, rim), 0.0)) * vec3(0.85, 0.93, 1.0);
  vec3 h = normalize(key + v);
  float gloss = max(dot(n, h), 0.0);
  result += (inside ? 0.02 : 0.060) * pow(gloss, 28.0) + (inside ? 0.0 : 0.035) * pow(gloss, 140.0);
  return result;
}

float zebra(vec3 n, vec3 v) {
  vec3 seen = normalize(mix(n, reflect(-v, n), reflection));
  float f = acos(clamp(dot(seen, stripe_direction), -1.0, 1.0)) / 3.14159265 * stripes;
  float per_pixel = max(fwidth(f), 1e-5);
  float from_edge = (abs(fract(f) - 0.5) - 0.25) / per_pixel;  // pixels from the nearest edge of a stripe
  // Stripes narrower than two pixels fade to their mean.
  return mix(clamp(from_edge + 0.5, 0.0, 1.0), 0.5, smoothstep(0.5, 1.0, per_pixel));
}

void main() {
  bool inside = !gl_FrontFacing;
  vec3 v = perspective ? normalize(vec3((0.5 * viewport - gl_FragCoord.xy) * pixel_slope, 1.0)) : vec3(0.0, 0.0, 1.0);
  vec3 n = dot(eye_normal, eye_normal) > 1e-8 ? normalize(eye_normal) : v;
  if (inside) n = -n;

#if MODE == 2
  float white = zebra(n, v);
  vec3 result = inside ? mix(vec3(0.10, 0.12, 0.16), vec3(0.66, 0.74, 0.82), white) : vec3(mix(0.045, 0.955, white));
#elif MODE == 3
  float at = clamp((map_value.x - range.x) * range.y, 0.0, 1.0);
  // Round an undefined point a spot of about two pixels is grey; wholly undefined triangles have no slope.
  float per_pixel = max(fwidth(map_value.y), 1e-4);
  float defined = clamp(map_value.y / per_pixel - 1.5, 0.0, 1.0);
  vec3 base = mix(undefined_color, texture(table, at * (255.0 / 256.0) + 0.5 / 256.0).rgb, defined);
  vec3 result = base * (0.70 + 0.30 * clamp(dot(n, v), 0.0, 1.0)) * (inside ? 0.75 : 1.0);
#else
#if MODE == 1
  vec3 base = inside ? patch_color.rgb * 0.6 : patch_color.rgb;
#elif MODE == 4
  vec3 base = inside ? inside_color : undefined_color * 1.1;
#else
  vec3 base = inside ? inside_color : outside_color;
#endif
  vec3 result = to_srgb(studio(to_linear(base), n, v, inside));
#endif

#if HIGHLIGHTS
  vec3 tint = patch_color.a > 0.75 ? selected_tint : hovered_tint;
  float strength = patch_color.a > 0.75 ? 0.42 : (patch_color.a > 0.25 ? 0.28 : 0.0);
  result = mix(result, tint * (0.55 + 0.45 * clamp(dot(n, v), 0.0, 1.0)), strength);
#endif
  result *= 1.0 - dimming;
#if MODE != 2
  result += dither();
#endif
  color = vec4(result, 1.0);
}
