#pragma once

// TriangleTree: nearest triangle queries, by a bounding volume hierarchy.

#include <limits>
#include <span>
#include <vector>

#include "core/geometry/box_tree.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

/// Bounding volume hierarchy over a copy of the triangles. Immutable; queries are thread-safe. O(n log n) to
/// build, O(log n) per query near the triangles.
class TriangleTree {
 public:
  /// Builds the tree. O(n log n).
  TriangleTree(std::span<const Vector3> positions, std::span<const std::array<Index, 3>> triangles);

  struct Nearest {
    /// The lowest number among equally near triangles; no_index when there is none.
    Index triangle = no_index;
    double distance = std::numeric_limits<double>::infinity();
  };
  /// Nearest triangle that is not farther than `limit`.
  Nearest nearest(const Vector3& point, double limit = std::numeric_limits<double>::infinity()) const;

  const ClosedTriangle& triangle(Index t) const { return closed_[t]; }

 private:
  std::vector<ClosedTriangle> closed_;
  BoxTree tree_;
};

}  // namespace hariko
