#pragma once

// TriangleTree: nearest triangles and crossings of rays, by a bounding volume hierarchy.

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
  /// Side of the triangles that a point is on: 1 where their normals point to, -1 behind them. Where several
  /// triangles are as near as the nearest one, as at edges, the one whose plane is farthest decides: the
  /// others are seen along themselves. 1 where all of them are without area.
  double side(const Vector3& point, const Nearest& nearest) const;

  /// Crossings that count, for triangles that bound a body and look outward.
  enum class Crossing { entering, leaving };
  /// Distance along a ray of unit direction to the first triangle that it crosses in the given way, at least
  /// `least` away; infinite where there is none. Triangles that the ray lies in, to 1e-6 of its length, are
  /// not crossed.
  double first_crossing(const Vector3& begin, const Vector3& direction, Crossing crossing,
                        double least = 0) const;

  /// Diagonal of the box round all triangles; 0 without any.
  double size() const { return size_; }
  const ClosedTriangle& triangle(Index t) const { return closed_[t]; }

 private:
  std::vector<ClosedTriangle> closed_;
  BoxTree tree_;
  double size_ = 0;
};

}  // namespace hariko
