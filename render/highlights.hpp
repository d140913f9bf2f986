#pragma once

// Elements of one object that are selected, hovered or complained about, over everything else. Internal to
// render/.

#include "render/painter.hpp"

namespace hariko::gl {

/// Edges by their curves where the surface is drawn, and by their straight lines where those are shown or
/// there is no curve; vertices. What the scene hides shows through faintly. `surface`: null where it is not
/// drawn.
void draw_highlights(Painter& painter, const Frame& frame, const SceneObject& object,
                     const PolyhedronBuffers& polyhedron, const MeshBuffers* surface, const Style& style);

}  // namespace hariko::gl
