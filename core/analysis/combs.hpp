#pragma once

// Curvature combs: teeth along the curves of a surface whose length is the curvature there.

#include <vector>

#include "core/base/cancellation.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Curvature combs of a set of curves. Curve c has the teeth c * (density + 1) .. + density, from one end to
/// the other at equal steps of its parameter. Curves do not share teeth, so a jump of curvature where two of
/// them meet shows as two teeth.
struct CurvatureCombs {
  int density = 0;
  std::vector<Vector3> points;  ///< foot of each tooth, relative to the surface's origin
  /// Curvature vector of the curve, reversed to point away from the centre of curvature, 1/length; zero where
  /// the curve has no direction.
  std::vector<Vector3> teeth;
  std::vector<Element> sources;  ///< source edge of each curve

  std::size_t curve_count() const { return sources.size(); }
};

/// Combs of the curves over source edges, boundary included; split edges inside source elements have none.
/// density >= 1. Empty when cancelled. In parallel. O(curves * density).
CurvatureCombs curvature_combs(const Surface& surface, int density, const CancelToken& cancel = {});

/// Typical curvature of combs, for automatic scaling: 95 % of the teeth do not exceed it, 1/length. 0 where
/// all curves are straight. O(teeth).
double typical_curvature(const CurvatureCombs& combs);

}  // namespace hariko
