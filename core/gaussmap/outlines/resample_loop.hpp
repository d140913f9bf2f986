#pragma once

// Resampling of loops on the same curve.

#include "core/gaussmap/outlines/outline.hpp"

namespace hariko {

/// Measure that is equal between consecutive points of a resampled loop.
enum class LoopMeasure {
  gauss_arc,  ///< arc length of the Gauss image: the turning of the normals
  arc         ///< arc length of the loop itself
};

/// Resamples to `count` points, at least 4, with normals and, where the loop has it, curvature, on the curve
/// through the loop's points (`LoopCurve`); the first one stays. Errors: those of `unusable`; E_DUP_NORMAL
/// where the normals do not turn along the loop and cannot serve as a measure. O(points + count log points).
Result<OutlineLoop> resample_loop(const OutlineLoop& loop, std::size_t count, LoopMeasure measure);

/// Inserts a point, in the middle of the curve from `place` to the next. Same errors.
Result<OutlineLoop> with_point_after(const OutlineLoop& loop, std::size_t place);

/// Reversed loop: the surface then lies on its other side.
OutlineLoop reversed(const OutlineLoop& loop);

}  // namespace hariko
