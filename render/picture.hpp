#pragma once

// Pictures without a window: what `hariko render` and tests call.

#include "core/base/result.hpp"
#include "render/camera.hpp"
#include "render/image.hpp"
#include "render/legend.hpp"
#include "render/renderer.hpp"
#include "render/scene.hpp"

namespace hariko {

inline constexpr Code e_picture_size{"E_PICTURE_SIZE"};
inline constexpr int max_picture_side = 8192;

/// Draws with 4 samples a pixel and, where the size allows it, twice the resolution averaged down. Makes and
/// drops its own context: call from any thread that has none. Errors: E_PICTURE_SIZE (1 .. 8192 a side),
/// E_NO_EGL, those of Renderer.
Result<Image> render_picture(const Scene& scene, const Camera& camera, int width, int height);

}  // namespace hariko
