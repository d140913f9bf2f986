#pragma once

// Scalar maps for display: one number per point of a grid, or per point of a seam.

#include <span>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko {

enum class MapKind {
  gauss,
  mean,
  k1,
  k2,
  largest,  ///< the larger of |k1| and |k2|
};

/// Curvature map: values[k * n + i] for grid point i of patches[k], n = pattern.point_count(). NaN where the
/// curvature is undefined: where there is no normal, and at corners without second derivatives. At corners
/// where these depend on the direction the value is the mean of the limits along three directions, so that no
/// grey speck suggests a broken surface. Signs and units as in `Curvature`. Thread-safe; runs on the calling
/// thread. O(values).
void map_values(const Surface& surface, MapKind kind, std::span<const Index> patches,
                const GridPattern& pattern, std::span<float> values);
std::vector<float> map_values(const Surface& surface, MapKind kind, const GridPattern& pattern,
                              std::span<const Index> patches);

/// Jump of the curvature tensor across a seam, relative to the mean of both sides' norms, at fractions i /
/// density: density + 1 values. 0 is curvature-continuous, 2 is the maximum. At the ends it is the limit
/// along the seam. NaN where a side has no curvature, where both are flat, and at ends without second
/// derivatives. Thread-safe. O(values).
void seam_curvature_jumps(const Surface& surface, Index seam, int density, std::span<float> values);

}  // namespace hariko
