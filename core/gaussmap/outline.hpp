#pragma once

// Outlines: closed loops of points with normals, what a surface is made from by its Gauss map
// (docs/gaussmap.md).

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// A closed loop; the last point is joined to the first. The surface lies on the left of the loop for who
/// looks from the tips of the normals.
struct OutlineLoop {
  std::vector<Vector3> points;
  std::vector<Vector3> normals;  ///< one a point, outward, of any length but zero
  std::vector<double>
      curvature;  ///< Gaussian curvature, one a point, 1 / length^2; empty where it is not known
  friend bool operator==(const OutlineLoop&, const OutlineLoop&) = default;
};

struct Outline {
  std::vector<OutlineLoop> loops;

  std::size_t point_count() const;
  /// Every loop has its curvature.
  bool has_curvature() const;
  /// Diagonal of the box around all points.
  double size() const;
  friend bool operator==(const Outline&, const Outline&) = default;
};

/// A point by its loop and place. `number` counts through all loops: it is the point's number among the
/// control points and the id of its vertex in the polyhedron that is made from them.
struct OutlinePoint {
  std::size_t loop = 0, place = 0;
  Index number = 0;
};

/// "point 3", or "point 3 of loop 1" where there are several loops. Both count from 0.
std::string to_string(const Outline& outline, const OutlinePoint& point);
/// The point with a number below `point_count()`.
OutlinePoint outline_point(const Outline& outline, Index number);

}  // namespace hariko
