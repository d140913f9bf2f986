// A square of the ground round the target.
uniform mat4 to_eye;  // ground coordinates (relative to a grid crossing near the target) to camera axes
uniform mat4 projection;
uniform float radius;
out vec2 ground;
out vec3 eye_position;

void main() {
  ground = radius * vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  vec4 eye = to_eye * vec4(ground, 0.0, 1.0);
  eye_position = eye.xyz;
  gl_Position = projection * eye;
}
