#pragma once

// EdgeTable: the corners of a polygon mesh grouped by the undirected edge they start, for meshes that need
// not be manifold. Shared by building connectivity, reporting its errors, and repairing it.

#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Use of an edge by one face: corner `corner` of the face list starts it, towards or from the vertex `high`.
struct EdgeUse {
  Index high;
  Index corner;
};

/// Table of the edges of a polygon mesh, with the faces that use each.
class EdgeTable {
 public:
  /// Collects the edges of the faces with used[f] != 0, or of all faces where `used` is empty. Those faces
  /// must have all indices in range and no vertex twice. O(corners) expected, O(corners log corners) at
  /// worst.
  explicit EdgeTable(const PolygonMesh& mesh, std::span<const char> used = {});

  /// Calls visit(low, high, uses) for every edge in ascending order of (low, high), low < high; uses ascend
  /// by corner.
  template <class Visit>
  void for_each_edge(Visit&& visit) const {
    for (Index low = 0; low + 1 < offsets_.size(); ++low) {
      for (Index begin = offsets_[low]; begin < offsets_[low + 1];) {
        Index end = begin + 1;
        while (end < offsets_[low + 1] && uses_[end].high == uses_[begin].high) ++end;
        visit(low, uses_[begin].high, std::span<const EdgeUse>(uses_.data() + begin, end - begin));
        begin = end;
      }
    }
  }

 private:
  void sort_bucket(Index begin, Index end);
  std::vector<Index> offsets_;  ///< per lower vertex, into uses_
  std::vector<EdgeUse> uses_;
};

/// Face of each corner. O(corners).
std::vector<Index> faces_of_corners(const PolygonMesh& mesh);

/// Whether an edge is manifold: one face, or two that traverse it in opposite directions.
inline bool is_manifold_edge(const PolygonMesh& mesh, std::span<const EdgeUse> uses) {
  return uses.size() == 1 ||
         (uses.size() == 2 && mesh.face_vertices[uses[0].corner] != mesh.face_vertices[uses[1].corner]);
}

}  // namespace hariko
