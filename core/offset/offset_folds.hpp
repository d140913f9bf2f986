#pragma once

// Folds of offset surfaces: where the distance is not smaller than the radius of curvature on that side.

#include <limits>

#include "core/base/cancellation.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Distances at which the offsets of a surface begin to fold, and the folds of one of them.
struct OffsetFolds {
  /// Smallest radius of curvature on the outside and on the inside: offsets fold from these distances on.
  /// Infinite where the surface never bends to that side.
  double outside = std::numeric_limits<double>::infinity();
  double inside = std::numeric_limits<double>::infinity();
  std::size_t patches = 0;          ///< patches with 1 + d k <= 0 for a principal curvature k
  Index worst = no_index;           ///< the one with the smallest radius on the side of the distance
  Vector3 place = Vector3::Zero();  ///< the point there, relative to the origin
};

/// Folds of the offset at a signed distance (positive outside), by 81 samples a square patch, 45 a triangle,
/// and a search uphill from the best of each patch to 1e-4 of its parameters. Corners whose second
/// derivatives have no meaning are left out up to 1e-3 of the parameters, as curvature may be unbounded
/// there. Of no use once cancelled. O(patches), in parallel.
OffsetFolds offset_folds(const Surface& surface, double distance, const CancelToken& cancel = {});

}  // namespace hariko
