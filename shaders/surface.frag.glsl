// The surface: a material in studio light, patch colours, stripes, a colour map, or a mirror of an environment.
// MODE: 0 shaded, 1 patches, 2 zebra, 3 values, 4 neutral (a base for coloured curves), 5 isophotes, 6 environment.
// TUBES, in MODE 2: the stripes are those of a ceiling at a finite distance.
// MATERIAL, in MODE 0: 0 clay, 1 porcelain, 2 metal, 3 wax, 4 rubber, 5 plastic.
uniform bool perspective;
uniform vec2 viewport;         // pixels
uniform float pixel_slope;     // slope of a view ray one pixel from the middle
uniform float middle_slope;    // slope of the ray through the middle, along y
uniform vec3 outside_color;    // sRGB
uniform vec3 inside_color;
uniform vec3 undefined_color;
uniform vec3 up_in_eye;        // the world's z in camera axes
uniform vec4 range;            // pivot, its place in the table, and slopes below and above it
uniform sampler1D table;
uniform float floor_value;     // values below it have a colour of their own
uniform vec3 floor_color;
uniform vec3 stripe_direction; // camera axes, unit
uniform float stripes;
uniform float dimming;         // 0 .. 1
uniform vec3 selected_tint;
uniform vec3 hovered_tint;
uniform bool triangles;        // the patches' domain
#if MODE == 2 && TUBES
uniform vec3 ceiling_middle;   // camera axes
uniform vec3 ceiling_normal;   // camera axes, unit, upwards
uniform float tubes_per_length;
#endif
#if MODE == 6
uniform sampler2D environment; // all directions; each level stands for a rougher surface
uniform mat3 to_environment;   // camera axes to those of its picture
uniform float roughest_level;  // stands for a matt surface
uniform float exposure;        // factor
#endif
uniform vec4 wire_paint;
uniform float line_width;  // width of the mesh lines, pixels

in vec3 eye_normal;
#if MODE == 2 && TUBES
in vec3 eye_place;
#endif
#if MODE == 3
in vec2 map_value;  // value, and 1 where it is defined
#endif
#if MODE == 1 || HIGHLIGHTS
flat in vec4 patch_color;
#endif
#if WIRE
in vec2 grid_place;
#endif
out vec4 color;

// Key from the upper left, a cooler fill from the right, a rim from behind: fixed to the camera like a photographer's
// lamps, over an ambient light that is brighter from above the ground.
const vec3 key = normalize(vec3(-0.55, 0.66, 0.50)), fill = normalize(vec3(0.75, -0.05, 0.55));
const vec3 rim = normalize(vec3(0.25, 0.55, -0.80));

vec3 ambient(vec3 n) {
  return mix(vec3(0.060, 0.058, 0.056), vec3(0.190, 0.200, 0.220), 0.5 + 0.5 * dot(n, up_in_eye));
}

vec3 clay(vec3 base, vec3 n, vec3 v, bool inside) {
  vec3 light = ambient(n);
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

#if MODE == 6 || (MODE == 0 && MATERIAL > 0)
float fresnel(float at_front, float facing) {
  return at_front + (1.0 - at_front) * pow(1.0 - facing, 5.0);
}
#endif

#if MODE == 6
// Light from a direction, averaged over the lobe of a level.
vec3 surroundings(vec3 ray, float level) {
  vec3 d = to_environment * ray;
  float turn = abs(d.x) + abs(d.y) > 1e-6 ? atan(d.x, d.y) : 0.0;
  vec2 place = vec2(0.5 + turn / 6.28318531, acos(clamp(d.z, -1.0, 1.0)) / 3.14159265);
  return textureLod(environment, place, level).rgb;
}
// A lacquer: a mirror with some haze over a matt coat of the object's colour. Where the surface bends so much that a
// pixel mirrors many texels, it takes their mean.
vec3 lacquer(vec3 base, vec3 n, vec3 v, vec3 mirrored, vec3 per_pixel) {
  float texels = length(per_pixel) * float(textureSize(environment, 0).y) / 3.14159265;
  float level = clamp(log2(max(texels, 1.0)), 0.0, roughest_level);
  float f = fresnel(0.40, clamp(dot(n, v), 0.0, 1.0));
  vec3 gloss = mix(surroundings(mirrored, level), surroundings(mirrored, max(level, 2.0)), 0.25);
  return exposure * (base * surroundings(n, roughest_level) * (1.0 - f) + f * gloss);
}
#endif

#if MODE == 0 && MATERIAL > 0
// A soft box: bright where the ray leaves through a rectangle that faces the object.
float soft_box(vec3 ray, vec3 middle, vec2 size, float blur) {
  vec3 across = normalize(cross(vec3(0.0, 1.0, 0.0), middle)), up = cross(middle, across);
  float along = dot(ray, middle);
  vec2 d = abs(vec2(dot(ray, across), dot(ray, up))) / max(along, 1e-3);
  vec2 in_box = 1.0 - smoothstep(size - blur, size + blur, d);
  return along > 0.0 ? in_box.x * in_box.y : 0.0;
}
// The studio as a mirror sees it.
vec3 room(vec3 ray, float blur) {
  float height = dot(ray, up_in_eye);
  vec3 walls = mix(vec3(0.030, 0.029, 0.028), vec3(0.20, 0.22, 0.25), smoothstep(-0.12 - blur, 0.12 + blur, height));
  walls += 0.30 * smoothstep(0.25, 1.0, height) * vec3(0.95, 0.98, 1.0);
  walls += soft_box(ray, key, vec2(0.62, 0.42), 0.05 + blur) * vec3(3.6, 3.5, 3.4);
  walls += soft_box(ray, normalize(vec3(0.86, 0.12, 0.40)), vec2(0.16, 0.80), 0.05 + blur) * vec3(1.5, 1.65, 1.8);
  return walls;
}
vec3 diffuse(vec3 n, vec3 wrap) {
  vec3 lit = max((dot(n, key) + wrap) / (1.0 + wrap), 0.0);
  return ambient(n) + 0.98 * lit * vec3(1.0, 0.975, 0.94) + 0.24 * max(dot(n, fill), 0.0) * vec3(0.80, 0.90, 1.0);
}
vec3 material(vec3 base, vec3 n, vec3 v) {
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec3 mirrored = reflect(-v, n);
#if MATERIAL == 1
  float f = fresnel(0.05, facing);
  return base * diffuse(n, vec3(0.18)) * 0.92 * (1.0 - f) + 1.6 * f * room(mirrored, 0.02);
#elif MATERIAL == 2
  vec3 tint = mix(base, vec3(1.0), fresnel(0.0, facing) * 0.8);
  return tint * (0.80 * room(mirrored, 0.16) + 0.62 * ambient(n) + 0.20 * max(dot(n, key) + 0.2, 0.0));
#elif MATERIAL == 3
  // Light that wandered under the skin comes out redder round the terminator and at thin rims.
  vec3 lit = diffuse(n, vec3(0.55, 0.30, 0.22));
  vec3 through = pow(1.0 - facing, 2.0) * 0.16 * vec3(1.0, 0.42, 0.28);
  float gloss = max(dot(n, normalize(key + v)), 0.0);
  return base * (0.90 * lit + through) + fresnel(0.03, facing) * 0.5 * ambient(n) + 0.055 * pow(gloss, 18.0);
#elif MATERIAL == 4
  float gloss = max(dot(n, normalize(key + v)), 0.0);
  float sheen = pow(1.0 - facing, 3.0);
  return base * diffuse(n, vec3(0.05)) + 0.085 * pow(gloss, 9.0) + 0.18 * sheen * (0.35 + max(dot(n, rim), 0.0));
#else
  float f = fresnel(0.04, facing);
  return base * diffuse(n, vec3(0.08)) * (1.0 - f) + 2.0 * f * room(mirrored, 0.05);
#endif
}
#endif

#if MODE == 2 || MODE == 5
// White and black by turns, each half of a unit of f wide.
float striped(float f) {
  float per_pixel = max(fwidth(f), 1e-5);
  float from_edge = (abs(fract(f) - 0.5) - 0.25) / per_pixel;  // pixels from the nearest edge of a stripe
  // Stripes narrower than two pixels fade to their mean.
  return mix(clamp(from_edge + 0.5, 0.0, 1.0), 0.5, smoothstep(0.5, 1.0, per_pixel));
}
float stripe(vec3 seen) {
  return striped(acos(clamp(dot(seen, stripe_direction), -1.0, 1.0)) / 3.14159265 * stripes);
}
#endif

#if MODE == 2 && TUBES
// The tubes of the ceiling where a mirrored ray meets it; dark for rays that do not rise.
float tube(vec3 ray) {
  float rise = dot(ray, ceiling_normal);
  float way = dot(ceiling_middle - eye_place, ceiling_normal) / max(rise, 1e-4);
  float lit = striped(dot(eye_place + way * ray - ceiling_middle, stripe_direction) * tubes_per_length);
  return lit * clamp(rise / max(fwidth(rise), 1e-5), 0.0, 1.0);
}
#endif

#if WIRE
// 1 on a line of the patch's grid.
float wire() {
  vec3 place = vec3(grid_place, grid_place.x + grid_place.y);
  vec3 per_pixel = max(fwidth(place), 1e-6);
  vec3 d = abs(fract(place - 0.5) - 0.5) / per_pixel;
  if (!triangles) d.z = 1e3;
  float line = clamp(0.5 * line_width + 0.6 - min(d.x, min(d.y, d.z)), 0.0, 1.0);
  // Cells of less than three pixels would only darken the surface.
  return line * (1.0 - smoothstep(0.15, 0.40, max(per_pixel.x, per_pixel.y)));
}
#endif

/// Direction from the fragment to an eye in perspective.
vec3 view_ray() {
  return normalize(vec3((0.5 * viewport - gl_FragCoord.xy) * pixel_slope - vec2(0.0, middle_slope), 1.0));
}

void main() {
  bool inside = !gl_FrontFacing;
  vec3 v = perspective ? view_ray() : vec3(0.0, 0.0, 1.0);
  vec3 n = dot(eye_normal, eye_normal) > 1e-8 ? normalize(eye_normal) : v;
  if (inside) n = -n;

#if MODE == 2
#if TUBES
  float white = tube(reflect(-v, n));
#else
  float white = stripe(reflect(-v, n));
#endif
  vec3 result = inside ? mix(vec3(0.10, 0.12, 0.16), vec3(0.66, 0.74, 0.82), white) : vec3(mix(0.045, 0.955, white));
#elif MODE == 5
  float white = stripe(n);
  vec3 base = inside ? inside_color : mix(outside_color, vec3(0.93), 0.5);
  vec3 result = mix(vec3(0.16, 0.17, 0.19), base, white) * (0.78 + 0.22 * clamp(dot(n, v), 0.0, 1.0));
#elif MODE == 3
  float at = clamp(range.y + (map_value.x - range.x) * (map_value.x < range.x ? range.z : range.w), 0.0, 1.0);
  // Round an undefined point a spot of about two pixels is grey; wholly undefined triangles have no slope.
  float per_pixel = max(fwidth(map_value.y), 1e-4);
  float defined = clamp(map_value.y / per_pixel - 1.5, 0.0, 1.0);
  vec3 mapped = texture(table, at * (255.0 / 256.0) + 0.5 / 256.0).rgb;
  mapped = map_value.x < floor_value ? floor_color : mapped;
  vec3 base = mix(undefined_color, mapped, defined);
  vec3 result = base * (0.70 + 0.30 * clamp(dot(n, v), 0.0, 1.0)) * (inside ? 0.75 : 1.0);
#elif MODE == 1
  vec3 result = to_srgb(clay(to_linear(inside ? patch_color.rgb * 0.6 : patch_color.rgb), n, v, inside));
#elif MODE == 4
  vec3 result = to_srgb(clay(to_linear(inside ? inside_color : undefined_color * 1.1), n, v, inside));
#elif MODE == 6
  vec3 mirrored = reflect(-v, n), per_pixel = fwidth(mirrored);
  vec3 result = to_srgb(inside ? clay(to_linear(inside_color), n, v, true)
                               : lacquer(to_linear(outside_color), n, v, mirrored, per_pixel));
#elif MATERIAL > 0
  vec3 result = to_srgb(inside ? clay(to_linear(inside_color), n, v, true) : material(to_linear(outside_color), n, v));
#else
  vec3 result = to_srgb(clay(to_linear(inside ? inside_color : outside_color), n, v, inside));
#endif

#if WIRE
  result = mix(result, wire_paint.rgb, wire() * wire_paint.a);
#endif
#if HIGHLIGHTS
  vec3 tint = patch_color.a > 0.75 ? selected_tint : hovered_tint;
  float strength = patch_color.a > 0.75 ? 0.42 : (patch_color.a > 0.25 ? 0.28 : 0.0);
  result = mix(result, tint * (0.55 + 0.45 * clamp(dot(n, v), 0.0, 1.0)), strength);
#endif
  result *= 1.0 - dimming;
#if MODE != 2 && MODE != 5
  result += dither();
#endif
  color = vec4(result, 1.0);
}
