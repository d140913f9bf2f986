#pragma once

// Ranges of curvature over a surface.

#include <optional>

#include "core/base/cancellation.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Least and greatest value of a curvature.
struct CurvatureRange {
  double least = 0, greatest = 0;
};

/// Ranges of Gaussian, mean and principal curvatures.
struct CurvatureStatistics {
  CurvatureRange gauss, mean, k1, k2;
};

/// Least and greatest curvatures over a grid of 8 intervals per patch side, without corners where the second
/// derivatives depend on the direction or do not exist, and without points that have no normal. Signs as in
/// `Curvature`. Nothing when no point is left or the computation was cancelled. O(patches).
std::optional<CurvatureStatistics> curvature_statistics(const Surface& surface,
                                                        const CancelToken& cancel = {});

}  // namespace hariko
