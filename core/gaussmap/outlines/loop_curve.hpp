#pragma once

// LoopCurve: the curve through the points of a loop, with normals.

#include <vector>

#include "core/gaussmap/outlines/outline.hpp"

namespace hariko {

/// Smooth closed curve through the points of a loop: cubic pieces whose tangents are perpendicular to the
/// normals. Normals turn smoothly from point to point and stay perpendicular to the curve; curvature is
/// interpolated by its logarithm where it has one sign, else linearly. Fourth order in the spacing for evenly
/// spaced points, third order otherwise.
class LoopCurve {
 public:
  struct Place {
    Vector3 point, normal;
    Vector3 tangent;       ///< unit, in the direction of the loop
    double curvature = 0;  ///< defined only if the loop has curvature
  };

  /// Prepares the curve. Consecutive points must be distinct and normals nonzero (see `unusable`).
  explicit LoopCurve(const OutlineLoop& loop);

  std::size_t piece_count() const { return loop_.points.size(); }
  /// Place at a fraction 0 .. 1 of the piece from point `piece` to the next. At 0 the given point, bit for
  /// bit.
  Place at(std::size_t piece, double fraction) const;

 private:
  OutlineLoop loop_;  ///< with normals of unit length
  std::vector<double> chords_;
  std::vector<Vector3> tangents_, turns_;  ///< derivatives of points and normals by chord length
  std::vector<double> values_, slopes_;    ///< curvature or its logarithm, and the derivatives
  double sign_ = 0;                        ///< sign of the curvature if values are logarithms, else 0
};

}  // namespace hariko
