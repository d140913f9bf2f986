layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 to_eye;
uniform mat4 projection;
uniform mat3 to_eye_normal;
uniform vec4 section;
out vec3 eye_normal;

void main() {
  vec3 eye = (to_eye * vec4(position, 1.0)).xyz;
  eye_normal = to_eye_normal * normal;
  gl_ClipDistance[0] = dot(section, vec4(eye, 1.0));
  gl_Position = projection * vec4(eye, 1.0);
}
