// A reference picture: a rectangle about the object's zero.
uniform mat4 to_eye;      // object to camera axes
uniform mat4 projection;
uniform vec2 half_sides;
out vec2 place;           // (0, 0) is the upper left corner, where files begin

void main() {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  place = vec2(0.5 + 0.5 * corner.x, 0.5 - 0.5 * corner.y);
  gl_Position = projection * to_eye * vec4(half_sides * corner, 0.0, 1.0);
}
