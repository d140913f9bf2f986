#pragma once

// Outlines round the surfaces of whole objects that are selected or hovered. Internal to render/.

#include <functional>

#include "render/frame_target.hpp"
#include "render/painter.hpp"

namespace hariko::gl {

/// True when an outline is asked for that has a surface to run round.
bool has_silhouettes(const Scene& scene);

/// Draws which object covers which pixel into `mask` (resized to the frame) and then the borders of those
/// areas into `picture`, over everything. Overlapping objects have a line of their own each. Errors:
/// E_GL_FRAMEBUFFER.
Result<Done> draw_silhouettes(Painter& painter, const Frame& frame, const Scene& scene,
                              const std::function<const MeshBuffers&(const DisplayMesh&)>& buffers_of,
                              FrameTarget& mask, const FrameTarget& picture, const Style& style);

}  // namespace hariko::gl
