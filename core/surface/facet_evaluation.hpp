#pragma once

// FacetEvaluation: optional interface of patch sets for meshing, beside `PatchSet`: points at any parameters
// without a virtual call each, and a certain bound of the patch over a triangle.

#include <array>
#include <span>

#include "core/surface/patch.hpp"

namespace hariko {

/// Parameters of the corners of a triangle within one patch's domain.
using ParameterTriangle = std::array<Vector2, 3>;

/// Ball of a bound.
struct HullBall {
  Vector3 centre = Vector3::Zero();
  double radius = 0;
};

/// Parameter at barycentric coordinates 1 - a - b, a, b.
inline Vector2 at_barycentric(const ParameterTriangle& triangle, double a, double b) {
  return triangle[0] + a * (triangle[1] - triangle[0]) + b * (triangle[2] - triangle[0]);
}

/// Evaluation for meshing, implemented by patch sets; consumers get it by `facet_evaluation`. Thread-safe.
class FacetEvaluation {
 public:
  virtual ~FacetEvaluation() = default;

  /// Positions, one per parameter. Agrees with `PatchSet::evaluate` to rounding.
  virtual void positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const = 0;
  /// Positions and first derivatives, one per parameter.
  virtual void first_order(Index patch, std::span<const Vector2> parameters,
                           std::span<PatchPoint> out) const = 0;

  /// Degree n >= 1 for which `hull` gives (n + 1)(n + 2) / 2 balls, 0 where the patch has no bound.
  virtual int hull_degree(Index patch) const = 0;
  /// Bound of the patch over a triangle: balls whose convex hull contains it. They are in the order of
  /// GridPattern{triangle, n}, and those of a side of that grid bound the curve over that side of the
  /// triangle. `samples` are the patch's positions at that grid. The bound converges with the square of the
  /// triangle's size.
  virtual void hull(Index patch, const ParameterTriangle& triangle, std::span<const Vector3> samples,
                    std::span<HullBall> out) const = 0;
};

/// The patch set as FacetEvaluation; null where it does not implement it.
inline const FacetEvaluation* facet_evaluation(const PatchSet& patches) {
  return dynamic_cast<const FacetEvaluation*>(&patches);
}

}  // namespace hariko
