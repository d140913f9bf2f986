// A point as a square on the screen; the fragment shader gives it its shape.
layout(location = 0) in uint number;

uniform samplerBuffer coordinates;
uniform int stride;
uniform mat4 to_eye;
uniform mat4 projection;
uniform vec2 viewport;
uniform float radius;  // pixels, with the outline
uniform float bias;
uniform bool perspective;
uniform vec4 section;   // camera axes: what lies on its negative side is cut away
uniform bool numbered;  // the attribute, or the instance's own number

#if COLORED
uniform samplerBuffer colors;
#endif

noperspective out vec2 offset;
#if COLORED
flat out vec4 own_paint;
#endif

void main() {
  int own = numbered ? int(number) : gl_InstanceID, at = own * stride;
#if COLORED
  own_paint = texelFetch(colors, own);
#endif
  vec3 p = vec3(texelFetch(coordinates, at).r, texelFetch(coordinates, at + 1).r, texelFetch(coordinates, at + 2).r);
  vec3 eye = (to_eye * vec4(p, 1.0)).xyz;
  gl_ClipDistance[0] = dot(section, vec4(eye, 1.0));
  vec4 here = projection * vec4(perspective ? eye * (1.0 - bias) : eye + vec3(0.0, 0.0, bias), 1.0);
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  offset = corner * (radius + 1.0);
  gl_Position = here + vec4(offset * 2.0 / viewport * here.w, 0.0, 0.0);
}
