// Ground grid in two densities that fade with distance and angle; the axes are coloured.
uniform float spacing;      // distance of the fine lines; the coarse ones are ten times as far apart
uniform float fine_weight;  // 0 .. 1
uniform float radius;
uniform vec2 axes;          // ground coordinates at which y = 0 and x = 0 lie
uniform vec3 line_color, x_color, y_color;
uniform float strength;
uniform float line_width;   // pixels
uniform bool perspective;
uniform vec3 normal_in_eye;
in vec2 ground;
in vec3 eye_position;
out vec4 color;

// Coverage of a pixel, 0 .. 1, by a line at distance d (in units of which a pixel covers `pixel`).
float coverage(float d, float pixel, float width) { return clamp(0.5 * width + 0.5 - abs(d) / pixel, 0.0, 1.0); }

float lines(float step_length, vec2 pixel) {
  vec2 d = abs(fract(ground / step_length + 0.5) - 0.5) * step_length;
  vec2 near = vec2(coverage(d.x, pixel.x, line_width), coverage(d.y, pixel.y, line_width));
  // Closer than four pixels the lines would merge: fade before that.
  vec2 room = smoothstep(vec2(6.0), vec2(24.0), step_length / (pixel * line_width));
  near *= room;
  return max(near.x, near.y);
}

void main() {
  vec2 pixel = max(fwidth(ground), vec2(1e-12));
  vec3 v = perspective ? normalize(-eye_position) : vec3(0.0, 0.0, 1.0);
  float facing = abs(dot(v, normal_in_eye));
  float fade = (1.0 - smoothstep(0.25, 1.0, length(ground) / radius)) * smoothstep(0.02, 0.30, facing);
  float fine = lines(spacing, pixel) * fine_weight * 0.45;
  float coarse = lines(spacing * 10.0, pixel);
  float on_x = coverage(ground.y - axes.x, pixel.y, 1.4 * line_width);
  float on_y = coverage(ground.x - axes.y, pixel.x, 1.4 * line_width);
  float alpha = max(fine, coarse) * strength;
  vec3 paint = line_color;
  if (on_x > 0.0) { paint = mix(paint, x_color, on_x); alpha = max(alpha, on_x * 0.80); }
  if (on_y > 0.0) { paint = mix(paint, y_color, on_y); alpha = max(alpha, on_y * 0.80); }
  color = vec4(paint, alpha * fade);
  if (color.a < 0.002) discard;
}
