// A piece of a curve as a quad of constant width on the screen. Instances hold the numbers of four points: previous,
// begin, end, next; where a curve begins or ends its end is repeated. COMB: points are teeth, even numbers their feet and
// odd ones their tips.
layout(location = 0) in uvec4 points;
layout(location = 1) in vec4 end_values;  // value and defined, or length along the curve and 1, of both ends

uniform samplerBuffer coordinates;
uniform int stride;        // floats a point
uniform mat4 to_eye;
uniform mat4 projection;
uniform vec2 viewport;     // pixels
uniform float half_width;  // pixels, with the casing
uniform float bias;        // towards the eye: a share of the distance (perspective) or a length (orthographic)
uniform bool perspective;
uniform float near_plane;
uniform vec4 section;      // camera axes: what lies on its negative side is cut away
uniform float amplitude;   // for combs: length of a tooth of curvature 1

noperspective out float side;  // pixels from the middle
noperspective out vec2 map_value;

vec3 point(int at) {
  return vec3(texelFetch(coordinates, at).r, texelFetch(coordinates, at + 1).r, texelFetch(coordinates, at + 2).r);
}
vec3 eye_point(uint number) {
#if COMB
  int at = int(number >> 1u) * stride;
  vec3 p = point(at) + ((number & 1u) != 0u ? amplitude : 0.0) * point(at + 3);
#else
  vec3 p = point(int(number) * stride);
#endif
  return (to_eye * vec4(p, 1.0)).xyz;
}
vec4 clip(vec3 eye) { return projection * vec4(perspective ? eye * (1.0 - bias) : eye + vec3(0.0, 0.0, bias), 1.0); }
vec2 pixel(vec4 p) { return p.xy / p.w * 0.5 * viewport; }
vec2 unit(vec2 v, vec2 otherwise) { return dot(v, v) > 1e-12 ? normalize(v) : otherwise; }
// Moves an end behind the eye to the near plane.
vec3 in_front(vec3 p, vec3 other) {
  float limit = -near_plane;
  if (!perspective || p.z <= limit || other.z >= limit) return p;
  return mix(p, other, (limit - p.z) / (other.z - p.z));
}

void main() {
  bool at_end = (gl_VertexID & 1) != 0;
  float hand = (gl_VertexID & 2) != 0 ? 1.0 : -1.0;
  vec3 begin = eye_point(points.y), end = eye_point(points.z);
  vec4 a = clip(in_front(begin, end)), b = clip(in_front(end, begin));
  vec2 along = unit(pixel(b) - pixel(a), vec2(1.0, 0.0));
  vec2 across = vec2(-along.y, along.x);
  vec4 here = at_end ? b : a;
  float reach = half_width + 1.0;
  vec2 offset = across * reach * hand;
  uint beyond = at_end ? points.w : points.x;
  uint own = at_end ? points.z : points.y;
  vec3 neighbour = eye_point(beyond);
  if (beyond != own && !(perspective && neighbour.z > -near_plane)) {
    vec2 other = at_end ? unit(pixel(clip(neighbour)) - pixel(b), along) : unit(pixel(a) - pixel(clip(neighbour)), along);
    vec2 mitre = unit(across + vec2(-other.y, other.x), across);
    offset = mitre * reach * hand / max(dot(mitre, across), 0.5);
  } else {
    offset += along * (at_end ? 0.5 : -0.5) * half_width;
  }
  side = reach * hand;
  map_value = at_end ? end_values.zw : end_values.xy;
  gl_ClipDistance[0] = 1.0;
  if (perspective && begin.z > -near_plane && end.z > -near_plane) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // wholly behind the eye
    return;
  }
  // By w: what is divided below is interpolated on the screen, and the cut of a long edge must not wander.
  gl_ClipDistance[0] = dot(section, vec4(at_end ? in_front(end, begin) : in_front(begin, end), 1.0)) / here.w;
  // Divided here: depth is linear on the screen, and clipping a quad whose ends differ much in w loses its width.
  gl_Position = vec4(here.xyz / here.w + vec3(offset * 2.0 / viewport, 0.0), 1.0);
}
