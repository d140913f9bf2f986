#pragma once

// Fitting of kept forms (`KeptForm`) that give the network of a refined polyhedron prescribed tangents.

#include <functional>
#include <optional>
#include <utility>

#include "core/base/result.hpp"
#include "core/patching/polyhedron_surface.hpp"

namespace hariko {

/// Wanted Bezier tangents of an edge, at its first vertex and at its second one.
using WantedTangents =
    std::function<std::optional<std::pair<Vector3, Vector3>>(VertexId first, VertexId second)>;

/// Wanted direction of the split edge (the inner patch boundary) of a face at a vertex.
using WantedSplits = std::function<std::optional<Vector3>(VertexId vertex, FaceId face)>;

/// Lengths of the edges before and behind a vertex that lies on a straight side of a face's chart, in any
/// unit; nothing for other vertices.
using WantedSides = std::function<std::optional<std::pair<double, double>>(VertexId vertex, FaceId face)>;

/// Wanted tangents, split directions and sides, as functions of the vertices.
struct WantedForm {
  WantedTangents tangents;
  WantedSplits splits;  ///< queried only at corners with an angle near pi
  WantedSides sides;
};

/// Returns the forms with which the network has the wanted tangents. `input` has frames by measure and no
/// kept forms yet. Vertices with pinned tangents get no form, nor do those with an edge for which no tangent
/// is wanted. The wishes are not queried for mirror images, which follow their originals. Errors: those of
/// the network. O(edges).
Result<FlatMap<VertexId, KeptForm>> kept_tangents(const PolyhedronSurfaceInput& input,
                                                  const WantedForm& wanted);

/// Whether the form is worth keeping: the vertex lies on a side, or a turn (radians), log stretch, lean or
/// three times the length of an offset exceeds 1e-3.
bool says_something(const KeptForm& form);

}  // namespace hariko
