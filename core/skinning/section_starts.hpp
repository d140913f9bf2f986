#pragma once

// Starts of closed sections, found so that neighbours are as near to each other as they can be.

#include <vector>

#include "core/skinning/subdivision_curve.hpp"

namespace hariko {

/// How two closed curves belong together when one of them begins elsewhere.
struct StartMatch {
  double start = 0;         ///< parameter of the second curve that belongs to 0 of the first, -1/2 .. 1/2
  double displacement = 0;  ///< mean of the squared distances at equal parameters, of centred curves
  double stiffness = 0;     ///< second derivative of the displacement by the start, not below 0
  double size = 0;          ///< root of the product of the curves' mean squares, which measures the above
};

/// The start of the least displacement, over all parameters of `second`, those between its points too. Places
/// of the curves do not matter: they are compared about their means. Of starts that are equally good (regular
/// polygons, circles of no extent) the nearest to 0 is taken. O(samples^2), samples about four a span.
StartMatch nearest_start(const SubdivisionCurve& first, const SubdivisionCurve& second);

/// The same curve run through the other way; its first point stays the first.
SubdivisionCurve reversed(const SubdivisionCurve& curve);

/// Starts (parameters of the sections that belong together, the first is 0) from what belongs together in
/// each strip. On a closed path the last meets the first: what is left over of whole turns is shared out
/// among the strips that are `free`, the softest most.
std::vector<double> chained_starts(const std::vector<StartMatch>& strips, const std::vector<char>& free,
                                   bool closed_path);

}  // namespace hariko
