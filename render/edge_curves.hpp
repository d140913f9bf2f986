#pragma once

// The curves of a surface that stand for the edges of the polyhedron that it is made from: what is seen of an
// edge, and so what is picked and emphasised.

#include <memory>
#include <span>
#include <vector>

#include "render/display_mesh.hpp"
#include "render/display_polyhedron.hpp"

namespace hariko {

/// Curves over each edge. Of an object with a live mirror an edge has its own curve and the
/// image's.
struct EdgeCurves {
  /// A curve, as segments of one kind that follow each other.
  struct Run {
    CurveKind kind = CurveKind::network;
    Index first = 0, count = 0;  ///< into segments(kind)
  };
  std::shared_ptr<const DisplayMesh::Curves> curves;  ///< what the numbers refer to
  std::vector<Index> offsets;                         ///< into `runs`: one for each edge, and the end
  std::vector<Run> runs;

  std::span<const Run> of(Index edge) const {
    return {runs.data() + offsets[edge], runs.data() + offsets[edge + 1]};
  }
  /// False for edges that the surface has no curve over.
  bool covers(Index edge) const { return edge + 1 < offsets.size() && offsets[edge] < offsets[edge + 1]; }
  std::span<const CurveSegment> segments(const Run& run) const {
    return std::span(curves->segments[std::size_t(run.kind)]).subspan(run.first, run.count);
  }
};

/// By the edges that the curves name; those that the polyhedron does not have (any more) are left out. Holds
/// for meshes and polyhedra that share their curves and edges with these. O(n log n).
std::shared_ptr<const EdgeCurves> edge_curves(const DisplayMesh& mesh, const DisplayPolyhedron& polyhedron);

}  // namespace hariko
