#pragma once

// Forces beside edges that kept forms hold, so that the faces of a refined polyhedron in mode FAIR lean as
// they did before (kuriyama.md section 12.7).

#include <vector>

#include "core/network/vertex_frames.hpp"
#include "core/patching/rim_bend.hpp"

namespace hariko {

/// Forces of the forms, in the units of the energy. Sharp edges have none.
std::vector<RimBend> form_pulls(const Polyhedron& polyhedron, const Shaping& shaping,
                                const VertexFrames& frames);

}  // namespace hariko
