layout(location = 0) in vec3 position;
uniform mat4 to_eye;
uniform mat4 projection;
uniform float bias;
uniform bool perspective;
uniform vec4 section;

void main() {
  vec3 eye = (to_eye * vec4(position, 1.0)).xyz;
  gl_ClipDistance[0] = dot(section, vec4(eye, 1.0));
  gl_Position = projection * vec4(perspective ? eye * (1.0 - bias) : eye + vec3(0.0, 0.0, bias), 1.0);
}
