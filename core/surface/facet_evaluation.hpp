#pragma once

// What a patch set may offer beside `PatchSet` to those who cut patches into many small triangles: points at
// any parameters without a virtual call each, and a certain bound of where the patch lies over a triangle.

#include <array>
#include <span>

#include "core/surface/patch.hpp"

namespace hariko {

/// Parameters of the corners of a triangle within one patch's domain.
using ParameterTriangle = std::array<Vector2, 3>;

struct HullBall {
  Vector3 centre = Vector3::Zero();
  double radius = 0;
};

/// Parameter at barycentric coordinates 1 - a - b, a, b.
inline Vector2 at_barycentric(const ParameterTriangle& triangle, double a, double b) {
  return triangle[0] + a * (triangle[1] - triangle[0]) + b * (triangle[2] - triangle[0]);
}

/// Implemented by patch sets themselves; consumers look for it by `facet_evaluation`. Thread-safe.
class FacetEvaluation {
 public:
  virtual ~FacetEvaluation() = default;

  /// One position a parameter. Agrees with `PatchSet::evaluate` to rounding.
  virtual void positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const = 0;
  /// Positions and first derivatives.
  virtual void first_order(Index patch, std::span<const Vector2> parameters,
                           std::span<PatchPoint> out) const = 0;

  /// n >= 1 where `hull` gives (n + 1)(n + 2) / 2 balls, 0 where the patch has no bound.
  virtual int hull_degree(Index patch) const = 0;
  /// Balls in whose convex hull the patch lies over the whole triangle. They are in the order of
  /// GridPattern{triangle, n}, and those of a side of that grid bound the curve over that side of the
  /// triangle. `samples` are the patch's positions at that grid. The hull is second-order tight in the
  /// triangle's size.
  virtual void hull(Index patch, const ParameterTriangle& triangle, std::span<const Vector3> samples,
                    std::span<HullBall> out) const = 0;
};

/// The patches' own fast evaluation; null where they have none.
inline const FacetEvaluation* facet_evaluation(const PatchSet& patches) {
  return dynamic_cast<const FacetEvaluation*>(&patches);
}

}  // namespace hariko
