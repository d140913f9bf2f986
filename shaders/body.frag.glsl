// A body that is seen through the surface round it: clear where it looks at the eye, denser towards its outline.
uniform bool perspective;
uniform vec2 viewport;       // pixels
uniform float pixel_slope;   // slope of a view ray one pixel from the middle
uniform float middle_slope;  // slope of the ray through the middle, along y
uniform vec4 front, rim;     // sRGB, with their opacities
uniform float reach;         // cosine from where on the front is painted alone

in vec3 eye_normal;
out vec4 color;

/// Direction from the fragment to an eye in perspective.
vec3 view_ray() {
  return normalize(vec3((0.5 * viewport - gl_FragCoord.xy) * pixel_slope - vec2(0.0, middle_slope), 1.0));
}

void main() {
  vec3 v = perspective ? view_ray() : vec3(0.0, 0.0, 1.0);
  float facing = clamp(dot(normalize(eye_normal), v), 0.0, 1.0);
  color = mix(rim, front, smoothstep(0.0, reach, facing));
}
