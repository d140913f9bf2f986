#pragma once

// Fitting of a subdivision curve with few control points to a freehand line.

#include <vector>

#include "core/base/result.hpp"
#include "core/subdivision/subdivision_curve.hpp"

namespace hariko {

inline constexpr Code e_short_stroke{"E_SHORT_STROKE"};

/// Fits a curve through points evenly spaced along the line, with corners where the line turns sharply (by
/// more than 50 degrees within about 8 tolerances or 4% of its length). Adds points where the curve is
/// farthest from the line, until it is within `tolerance` of it, or until there are 60. Ends of an open curve
/// are those of the line. Errors: E_SHORT_STROKE where the line is shorter than four tolerances. `tolerance`
/// > 0, in the unit of the points. O(60 x points of the line x points of the curve).
Result<SubdivisionCurve> freehand_curve(const std::vector<Vector3>& line, bool closed, double tolerance);

}  // namespace hariko
