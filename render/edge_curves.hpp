#pragma once

// Curves of a surface that represent the edges of its source polyhedron, for display, picking and emphasis.

#include <memory>
#include <span>
#include <vector>

#include "render/display_mesh.hpp"
#include "render/display_polyhedron.hpp"

namespace hariko {

/// Curves over each edge. In an object with a live mirror an edge has its own curve and that of its image.
struct EdgeCurves {
  /// Curve, as consecutive segments of one kind.
  struct Run {
    CurveKind kind = CurveKind::network;
    Index first = 0, count = 0;  ///< into segments(kind)
  };
  std::shared_ptr<const DisplayMesh::Curves> curves;  ///< segments that the runs refer to
  std::vector<Index> offsets;                         ///< into `runs`: by edge, and the end
  std::vector<Run> runs;

  /// Curves over an edge.
  std::span<const Run> of(Index edge) const {
    return {runs.data() + offsets[edge], runs.data() + offsets[edge + 1]};
  }
  /// Whether the surface has a curve over the edge.
  bool covers(Index edge) const { return edge + 1 < offsets.size() && offsets[edge] < offsets[edge + 1]; }
  /// Segments of a curve.
  std::span<const CurveSegment> segments(const Run& run) const {
    return std::span(curves->segments[std::size_t(run.kind)]).subspan(run.first, run.count);
  }
};

/// Assigns curves to the edges that they name; curves of edges that the polyhedron does not have are left
/// out. Valid for all meshes and polyhedra that share these curves and edges. O(n log n).
std::shared_ptr<const EdgeCurves> edge_curves(const DisplayMesh& mesh, const DisplayPolyhedron& polyhedron);

}  // namespace hariko
