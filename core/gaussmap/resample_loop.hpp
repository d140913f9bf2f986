#pragma once

// Loops with other points on the same curve.

#include "core/gaussmap/outline.hpp"

namespace hariko {

/// What is the same from each point of a resampled loop to the next.
enum class LoopMeasure {
  gauss_arc,  ///< the arc length of the Gauss image: the turning of the normals
  arc         ///< the arc length of the loop itself
};

/// `count` points, at least 4, with normals and, where the loop has it, curvature, on the curve through the
/// loop's points (`LoopCurve`); the first one stays. Errors: those of `unusable`; E_DUP_NORMAL where the
/// normals do not turn along the loop and cannot be a measure. O(points + count log points).
Result<OutlineLoop> resample_loop(const OutlineLoop& loop, std::size_t count, LoopMeasure measure);

/// The loop with one more point, in the middle of the curve from `place` to the next. Same errors.
Result<OutlineLoop> with_point_after(const OutlineLoop& loop, std::size_t place);

/// The same loop run through the other way: the surface then lies on its other side.
OutlineLoop reversed(const OutlineLoop& loop);

}  // namespace hariko
