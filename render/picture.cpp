#include "render/picture.hpp"

#include <algorithm>
#include <string>

#include "render/offscreen.hpp"

namespace hariko {

namespace {

// Above this many pixels the doubled picture would take hundreds of megabytes for little gain.
constexpr std::int64_t most_doubled_pixels = 20'000'000;

}  // namespace

Result<Image> render_picture(const Scene& scene, const Camera& camera, int width, int height) {
  if (width < 1 || height < 1 || width > max_picture_side || height > max_picture_side)
    return make_error(e_picture_size,
                      "A picture of " + std::to_string(width) + " by " + std::to_string(height) +
                          " pixels was asked for; each side may have 1 to " +
                          std::to_string(max_picture_side) + ".",
                      "Choose another size.");
  Result<OffscreenContext> context = OffscreenContext::create();
  if (!context) return context.error();
  Result<Renderer> renderer = Renderer::create();
  if (!renderer) return renderer.error();
  Renderer drawing = std::move(renderer).value();
  const int factor =
      std::int64_t(width) * height * 4 <= most_doubled_pixels && 2 * std::max(width, height) <= 8192 ? 2 : 1;
  Scene scaled = scene;
  scaled.pixel_scale *= factor;
  const FrameOptions options{{width * factor, height * factor}, 4};
  if (Result<Done> drawn = drawing.draw(scaled, camera, options); !drawn) return drawn.error();
  return downsample(drawing.read(), factor);
}

}  // namespace hariko
