#pragma once

// LoopCurve: what lies between the points of a loop.

#include <vector>

#include "core/gaussmap/outline.hpp"

namespace hariko {

/// The smooth closed curve through the points of a loop: cubic pieces whose tangents are perpendicular to the
/// normals. Normals turn smoothly from point to point and stay perpendicular to the curve; curvature is
/// interpolated by its logarithm, where it is given and of one sign, else linearly. Fourth order in the
/// spacing for evenly spaced points, third order otherwise.
class LoopCurve {
 public:
  struct Place {
    Vector3 point, normal;
    Vector3 tangent;       ///< unit, in the direction of the loop
    double curvature = 0;  ///< meaningful where the loop has curvature
  };

  /// The loop's neighbours are apart, its normals have lengths (see `unusable`).
  explicit LoopCurve(const OutlineLoop& loop);

  std::size_t piece_count() const { return loop_.points.size(); }
  /// Fraction 0 .. 1 of the way from point `piece` to the next. At 0 the given point, bit for bit.
  Place at(std::size_t piece, double fraction) const;

 private:
  OutlineLoop loop_;  ///< normals of unit length
  std::vector<double> chords_;
  std::vector<Vector3> tangents_, turns_;  ///< of points and normals, by chord length
  std::vector<double> values_, slopes_;    ///< of the curvature, or its logarithm
  double sign_ = 0;                        ///< of the curvature when values are logarithms, else 0
};

}  // namespace hariko
