// Compiled for each MODE and MATERIAL (see surface.frag.glsl), with and without HIGHLIGHTS, WIRE and TUBES.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 value;  // and 1 where it is defined

uniform mat4 to_eye;       // object (relative to the mesh's origin) to camera axes
uniform mat4 projection;
uniform mat3 normal_to_eye;
uniform vec4 section;      // camera axes: what lies on its negative side is cut away
uniform int vertices_per_patch;
uniform samplerBuffer patch_colors;
#if WIRE
uniform samplerBuffer grid_places;  // places of a patch's points, in intervals
#endif

out vec3 eye_normal;
#if MODE == 3
out vec2 map_value;
#endif
#if MODE == 1 || HIGHLIGHTS
flat out vec4 patch_color;  // rgb, and in alpha: 0 plain, about 0.5 hovered, 1 selected
#endif
#if WIRE
out vec2 grid_place;
#endif
#if MODE == 2 && TUBES
out vec3 eye_place;
#endif

void main() {
  vec4 eye = to_eye * vec4(position, 1.0);
  eye_normal = normal_to_eye * normal;
#if MODE == 3
  map_value = value;
#endif
#if MODE == 1 || HIGHLIGHTS
  patch_color = texelFetch(patch_colors, gl_VertexID / vertices_per_patch);
#endif
#if WIRE
  grid_place = texelFetch(grid_places, gl_VertexID % vertices_per_patch).rg;
#endif
#if MODE == 2 && TUBES
  eye_place = eye.xyz;
#endif
  gl_Position = projection * eye;
  gl_ClipDistance[0] = dot(section, eye);
}
