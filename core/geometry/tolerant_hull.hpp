#pragma once

// TolerantHull: the convex hull of points known within a tolerance, without vertices in the middle of edges
// and faces. `ConvexHull` decides exactly instead, and keeps them.

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Convex hull with a tolerance. Triangles are counter-clockwise seen from outside; indices are those of the
/// given points. Empty where all points lie in a plane.
struct TolerantHull {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> vertices;  ///< ascending
};

/// Convex hull of points: a point that lies within `tolerance` (a length) of the hull of the others is not a
/// vertex. Points in one plane become triangles in that plane. The same result for the same input. Typically
/// O(n log n), O(n^2) at worst.
TolerantHull tolerant_hull(std::span<const Vector3> points, double tolerance);

/// Convexity of a point set: true when no point lies deeper inside the hull than 1e-6 of the diagonal of
/// their bounding box. O(points times hull triangles).
bool is_convex(std::span<const Vector3> points);

}  // namespace hariko
