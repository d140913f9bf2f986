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

/// Wanted direction of the split edge of a face at a vertex.
using WantedSplits = std::function<std::optional<Vector3>(VertexId vertex, FaceId face)>;

/// Lengths of the edges before and behind a vertex that lies on a straight side of a face's chart, in any
/// unit; none for other vertices.
using WantedSides = std::function<std::optional<std::pair<double, double>>(VertexId vertex, FaceId face)>;

struct WantedForm {
  WantedTangents tangents;
  WantedSplits splits;  ///< asked for at corners of nearly a half turn only
  WantedSides sides;
};

/// Forms with which the network has the wanted tangents. `input` has frames by measure and keeps no form yet.
/// Vertices with pinned tangents get none, nor do those with an edge of which nothing is wanted. Of copies by
/// a mirror nothing is asked: they follow. Errors: those of the network. O(edges).
Result<FlatMap<VertexId, KeptForm>> kept_tangents(const PolyhedronSurfaceInput& input,
                                                  const WantedForm& wanted);

/// Whether some number of the form is above a thousandth, or the vertex lies on a side: what is less is not
/// worth keeping.
bool says_something(const KeptForm& form);

}  // namespace hariko
