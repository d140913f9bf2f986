#pragma once

// Emphasis of what is selected, hovered or faulty: outlines round whole objects, and elements of one object
// drawn over everything else. Internal to render/.

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

/// Draws the highlights of an object: edges by their curves where the surface is drawn, and by straight lines
/// where those are shown or there is no curve; also vertices. Parts that the scene hides show through
/// faintly. `surface`: null where it is not drawn.
void draw_highlights(Painter& painter, const Frame& frame, const SceneObject& object,
                     const PolyhedronBuffers& polyhedron, const MeshBuffers* surface, const Style& style);

}  // namespace hariko::gl
