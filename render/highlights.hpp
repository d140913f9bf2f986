#pragma once

// Highlights: selected, hovered or faulty elements of one object, drawn over everything else. Internal to
// render/.

#include "render/painter.hpp"

namespace hariko::gl {

/// Draws the highlights of an object: edges by their curves where the surface is drawn, and by straight lines
/// where those are shown or there is no curve; also vertices. Parts that the scene hides show through
/// faintly. `surface`: null where it is not drawn.
void draw_highlights(Painter& painter, const Frame& frame, const SceneObject& object,
                     const PolyhedronBuffers& polyhedron, const MeshBuffers* surface, const Style& style);

}  // namespace hariko::gl
