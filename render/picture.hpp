#pragma once

// Pictures without a window, for `hariko render` and tests.

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
/// Largest width and height of a picture, pixels.
inline constexpr int max_picture_side = 8192;

/// Size check: E_PICTURE_SIZE where a side is not 1 .. 8192.
Result<Done> check_picture_size(int width, int height);

/// Draws pictures in its own GL context, which is current on the creating thread during the drawer's life;
/// for threads without a context. Uses 4 samples per pixel and, where the size allows it, doubled resolution
/// averaged down.
class PictureDrawer {
 public:
  /// Creates context and renderer. Errors: E_NO_EGL, those of Renderer::create.
  static Result<PictureDrawer> create();
  /// Draws one picture. Errors: E_PICTURE_SIZE, those of Renderer::draw.
  Result<Image> draw(const Scene& scene, const Camera& camera, PixelSize size);

 private:
  PictureDrawer(OffscreenContext context, Renderer renderer)
      : context_(std::move(context)), renderer_(std::move(renderer)) {}
  OffscreenContext context_;
  Renderer renderer_;  ///< declared after the context, so destroyed before it
};

/// Draws one picture with a drawer of its own. Errors: those of PictureDrawer.
Result<Image> render_picture(const Scene& scene, const Camera& camera, int width, int height);

}  // namespace hariko
