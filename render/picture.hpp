#pragma once

// Pictures without a window: what `hariko render` and tests call.

#include "core/base/result.hpp"
#include "render/camera.hpp"
#include "render/image.hpp"
#include "render/legend.hpp"
#include "render/offscreen.hpp"
#include "render/renderer.hpp"
#include "render/scene.hpp"

namespace hariko {

inline constexpr Code e_picture_size{"E_PICTURE_SIZE"};
inline constexpr Code e_nothing_to_show{"E_NOTHING_TO_SHOW"};
inline constexpr int max_picture_side = 8192;

/// E_PICTURE_SIZE where a side is not 1 .. 8192.
Result<Done> check_picture_size(int width, int height);

/// Draws pictures in a context of its own, which is current on the thread that made it while this lives: for
/// threads that have none. Draws with 4 samples a pixel and, where the size allows it, twice the resolution
/// averaged down.
class PictureDrawer {
 public:
  /// Errors: E_NO_EGL, those of Renderer::create.
  static Result<PictureDrawer> create();
  /// Errors: E_PICTURE_SIZE, those of Renderer::draw.
  Result<Image> draw(const Scene& scene, const Camera& camera, PixelSize size);

 private:
  PictureDrawer(OffscreenContext context, Renderer renderer)
      : context_(std::move(context)), renderer_(std::move(renderer)) {}
  OffscreenContext context_;
  Renderer renderer_;  ///< after the context: goes before it
};

/// One picture by a drawer of its own.
Result<Image> render_picture(const Scene& scene, const Camera& camera, int width, int height);

}  // namespace hariko
