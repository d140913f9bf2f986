#include "render/picture.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace hariko {

namespace {

// Number of pixels above which the doubled picture would take hundreds of megabytes for little gain.
constexpr std::int64_t most_doubled_pixels = 20'000'000;

}  // namespace

Result<Done> check_picture_size(int width, int height) {
  if (width >= 1 && height >= 1 && width <= max_picture_side && height <= max_picture_side) return Done{};
  return make_error(e_picture_size,
                    "A picture of " + std::to_string(width) + " by " + std::to_string(height) +
                        " pixels was asked for; each side may have 1 to " + std::to_string(max_picture_side) +
                        ".",
                    "Choose another size.");
}

Result<PictureDrawer> PictureDrawer::create() {
  Result<OffscreenContext> context = OffscreenContext::create();
  if (!context) return context.error();
  Result<Renderer> renderer = Renderer::create();
  if (!renderer) return renderer.error();
  return PictureDrawer(std::move(context).value(), std::move(renderer).value());
}

Result<Image> PictureDrawer::draw(const Scene& scene, const Camera& camera, PixelSize size) {
  if (const auto checked = check_picture_size(size.width, size.height); !checked) return checked.error();
  const bool doubled = std::int64_t(size.width) * size.height * 4 <= most_doubled_pixels &&
                       2 * std::max(size.width, size.height) <= max_picture_side;
  const int factor = doubled ? 2 : 1;
  Scene scaled = scene;
  scaled.pixel_scale *= factor;
  const DrawOptions options{{size.width * factor, size.height * factor}, 4};
  if (Result<Done> drawn = renderer_.draw(scaled, camera, options); !drawn) return drawn.error();
  return downsample(renderer_.read(), factor);
}

Result<Image> render_picture(const Scene& scene, const Camera& camera, int width, int height) {
  if (const auto checked = check_picture_size(width, height); !checked) return checked.error();
  Result<PictureDrawer> drawer = PictureDrawer::create();
  if (!drawer) return drawer.error();
  PictureDrawer drawing = std::move(drawer).value();
  return drawing.draw(scene, camera, {width, height});
}

}  // namespace hariko
