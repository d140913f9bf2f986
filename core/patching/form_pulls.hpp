#pragma once

// Forces beside edges that kept forms hold, so that the faces of a refined polyhedron in mode FAIR lean as
// they did before (kuriyama.md section 12.7).

#include <array>
#include <functional>
#include <vector>

#include "core/base/result.hpp"
#include "core/network/vertex_frames.hpp"
#include "core/patching/polyhedron_surface.hpp"
#include "core/patching/rim_bend.hpp"

namespace hariko {

/// Forces of the forms, in the units of the energy. Sharp edges have none.
std::vector<RimBend> form_pulls(const Polyhedron& polyhedron, const Shaping& shaping,
                                const VertexFrames& frames);

/// Places along an edge where normals are wanted, as shares of its parameter.
inline constexpr std::array wanted_shares{0.25, 0.5, 0.75};
/// Unit normals there, from the first vertex on; empty where the edge may lean as it likes.
using WantedNormals = std::function<std::vector<Vector3>(VertexId first, VertexId second)>;

/// The forms of `input`, which has frames by measure and mode FAIR, with the pulls that give its edges the
/// wanted normals. Copies by a mirror follow: `image` scales the coordinates to make their normals. Errors:
/// those of the network.
Result<FlatMap<VertexId, KeptForm>> with_pulls(const PolyhedronSurfaceInput& input, const Vector3& image,
                                               const WantedNormals& wanted);

}  // namespace hariko
