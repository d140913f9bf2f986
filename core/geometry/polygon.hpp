#pragma once

// Polygons in space and in the plane: normals, areas, flattening, shape, points inside.

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Newell normal of the closed polygon at(0) .. at(count - 1): direction of the mean plane, length twice the
/// projected area. Computed relative to the first corner, so that a polygon far from the origin is as precise
/// as one at the origin.
template <class At>
Vector3 newell_normal(std::size_t count, const At& at) {
  Vector3 sum = Vector3::Zero();
  if (count < 3) return sum;
  const Vector3 first = at(0);
  for (std::size_t i = 1; i + 1 < count; ++i) sum += (at(i) - first).cross(at(i + 1) - first);
  return sum;
}
Vector3 newell_normal(std::span<const Vector3> corners);

/// Centroid of the area of a closed polygon; of one without area (within 1e-12 of its extent squared) the
/// mean of its corners. Exact for planar polygons, concave ones too. At least one corner. O(n).
Vector3 polygon_centre(std::span<const Vector3> corners);

/// Coordinates of points in the plane through `origin` at right angles to a unit normal, seen from its tip.
std::vector<Vector2> flattened(std::span<const Vector3> points, const Vector3& origin, const Vector3& normal);

/// Twice the signed area, positive where the corners run counter-clockwise.
inline double twice_area(const Vector2& a, const Vector2& b, const Vector2& c) {
  return cross(b - a, c - a);
}
double twice_area(std::span<const Vector2> corners);

/// Whether a point lies inside a polygon, by the even-odd rule. Points on a side count to either.
bool inside_polygon(std::span<const Vector2> corners, const Vector2& point);

enum class FaceShape { convex, concave, self_crossing };

/// Shape of a polygon that need not be planar, judged along the Newell normal (where that vanishes, in the
/// plane of the two longest independent diagonals). `self_crossing`: two sides cross in a point inside both.
/// `concave`: a corner turns inwards by a triangle of more than 1e-4 of the polygon's area (the reflex test
/// of kuriyama.md section 11). Polygons within a line are convex. Typically O(n log n) in the number of
/// corners; the search for crossings stops after 2,000,000 pairs of sides.
FaceShape classify_face(std::span<const Vector3> corners);

}  // namespace hariko
