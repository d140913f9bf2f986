#pragma once

// Outlines round the surfaces of objects that are selected or hovered as a whole. Internal to render/.

#include <functional>

#include "render/frame_target.hpp"
#include "render/painter.hpp"

namespace hariko::gl {

/// Whether any object with a surface is to be outlined.
bool has_silhouettes(const Scene& scene);

/// Draws an object mask into `mask` (resized to the frame), then the borders of its areas into `picture`,
/// over everything. Overlapping objects have separate lines. Errors: E_GL_FRAMEBUFFER.
Result<Done> draw_silhouettes(Painter& painter, const Frame& frame, const Scene& scene,
                              const std::function<const MeshBuffers&(const DisplayMesh&)>& buffers_of,
                              FrameTarget& mask, const FrameTarget& picture, const Style& style);

}  // namespace hariko::gl
