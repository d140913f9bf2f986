#pragma once

// TriangleTree: the nearest of many triangles, by a tree of boxes.

#include <limits>
#include <span>
#include <vector>

#include "core/geometry/box_tree.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

/// Closed triangles over a copy of their corners. Immutable; queries are thread-safe. O(n log n) to make,
/// O(log n) a query near the triangles.
class TriangleTree {
 public:
  TriangleTree(std::span<const Vector3> positions, std::span<const std::array<Index, 3>> triangles);

  struct Nearest {
    Index triangle = no_index;  ///< of several as near, the one of the smallest number; no_index when none
    double distance = std::numeric_limits<double>::infinity();
  };
  /// The nearest triangle that is not farther than `limit`.
  Nearest nearest(const Vector3& point, double limit = std::numeric_limits<double>::infinity()) const;

  const ClosedTriangle& triangle(Index t) const { return closed_[t]; }

 private:
  std::vector<ClosedTriangle> closed_;
  BoxTree tree_;
};

}  // namespace hariko
