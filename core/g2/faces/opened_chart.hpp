#pragma once

// Opened chart: coordinates in which the energy of a face is taken where corners are turned about themselves
// (g2.md section 5).

#include <Eigen/Core>

#include "core/g2/faces/jet3.hpp"

namespace hariko {

/// Change of a function's derivatives (x, y, xx, xy, yy, xxx, xxy, xyy, yyy) from the chart's coordinates to
/// other ones.
struct CoordinateChange {
  Eigen::Matrix<double, 9, 9> matrix;
  double area = 1;  ///< Determinant of the new coordinates' derivatives by the chart's.

  /// `first`, `second`: the new coordinates as functions of the chart's.
  CoordinateChange(const Jet3& first, const Jet3& second);
  Jet3 operator()(const Jet3& f) const;
};

}  // namespace hariko
