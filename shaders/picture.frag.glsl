// A reference picture in its own colours, which are multiplied by alpha, under no light.
uniform sampler2D pixels;
uniform float opacity;
in vec2 place;
out vec4 color;

void main() {
  color = texture(pixels, place) * opacity;
  if (color.a < 0.002) discard;
}
