#pragma once

// TolerantHull: the convex hull of points whose places are known within a tolerance, without vertices in the
// middle of edges and faces. `ConvexHull` decides exactly instead, and keeps them.

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Triangles are counter-clockwise seen from outside; indices are those of the points given. Empty where all
/// points lie in a plane.
struct TolerantHull {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> vertices;  ///< ascending
};

/// Points that lie within `tolerance` (a length) of the hull of the others are not vertices of it. Points in
/// one plane make triangles in that plane. The same for the same input. O(n log n) typically, O(n^2) at
/// worst.
TolerantHull tolerant_hull(std::span<const Vector3> points, double tolerance);

/// No point lies deeper in the hull of all than 1e-6 of their size.
bool is_convex(std::span<const Vector3> points);

}  // namespace hariko
