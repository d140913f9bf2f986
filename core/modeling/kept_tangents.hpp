#pragma once

// Tangents that the network of a refined polyhedron would not have by itself, as the forms that its vertices
// keep.

#include <functional>
#include <optional>
#include <utility>

#include "core/base/result.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

/// Wanted Bezier tangents of an edge, at its first vertex and at its second one.
using WantedTangents =
    std::function<std::optional<std::pair<Vector3, Vector3>>(VertexId first, VertexId second)>;

/// Forms with which the network has the wanted tangents. `input` has frames by measure and keeps no form yet.
/// Vertices with pinned tangents get none, nor do those with an edge of which nothing is wanted. Of copies by
/// a mirror nothing is asked: they follow. Errors: those of the network. O(edges).
Result<FlatMap<VertexId, KeptForm>> kept_tangents(const PolyhedronSurfaceInput& input,
                                                  const WantedTangents& wanted);

/// Whether some number of the form is above a thousandth: what is less is not worth keeping.
bool says_something(const KeptForm& form);

}  // namespace hariko
