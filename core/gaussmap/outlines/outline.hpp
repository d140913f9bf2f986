#pragma once

// Outlines: closed loops of points with normals, from which a surface is made by its Gauss map
// (docs/gaussmap.md).

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Closed loop; the last point is joined to the first. Seen from the tips of the normals, the surface lies on
/// the left of the loop.
struct OutlineLoop {
  std::vector<Vector3> points;
  std::vector<Vector3> normals;   ///< one per point, outward, of any nonzero length
  std::vector<double> curvature;  ///< Gaussian curvature, one per point, 1 / length^2; empty where unknown.
  friend bool operator==(const OutlineLoop&, const OutlineLoop&) = default;
};

/// Loops that bound one surface.
struct Outline {
  std::vector<OutlineLoop> loops;

  std::size_t point_count() const;
  /// Whether every loop has curvature.
  bool has_curvature() const;
  /// Diagonal of the bounding box of all points.
  double size() const;
  friend bool operator==(const Outline&, const Outline&) = default;
};

/// Point by its loop and place. `number` counts through all loops: it is the point's number among the control
/// points and the id of its vertex in the polyhedron made from them.
struct OutlinePoint {
  std::size_t loop = 0, place = 0;
  Index number = 0;
};

/// Name of a point: "point 3", or "point 3 of loop 1" where there are several loops. Both count from 0.
std::string to_string(const Outline& outline, const OutlinePoint& point);
/// Point with a number below `point_count()`.
OutlinePoint outline_point(const Outline& outline, Index number);

}  // namespace hariko
