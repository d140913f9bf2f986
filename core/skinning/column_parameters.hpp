#pragma once

// Where columns of a grid touch the sections, so that the curves through those points are near to them.

#include <functional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/skinning/subdivision_curve.hpp"

namespace hariko {

std::vector<double> uniform_parameters(int columns, bool closed);

/// Parameters u_0 < u_1 < ... that minimise the squared distance, summed over the sections, between each
/// section and the subdivision curve through its points at them. Open: from 0 to 1; closed: within one turn,
/// the first anywhere near 0. Widths are a softmax, so the order cannot break. Levenberg and Marquardt from
/// five seeds (uniform, arc length, curvature, and on control points of the sections, closer together at one
/// end or at the other), at most 60 evaluations each; the best result wins. Curves have many optima: the
/// first three seeds alone, which are the specification's, end in worse ones (docs/skinning.md). `step` is
/// called after each of the `optimiser_seeds` seeds. Cancelled, it gives the best so far. `starts`, one a
/// section or none: parameters of closed sections that u counts from.
std::vector<double> optimised_parameters(const std::vector<SubdivisionCurve>& sections, int columns,
                                         const CancelToken& cancel = {},
                                         const std::function<void()>& step = {},
                                         const std::vector<double>& starts = {});
inline constexpr std::size_t optimiser_seeds = 5;

/// Root of the mean squared distance that is minimised.
double parameter_error(const std::vector<SubdivisionCurve>& sections, const std::vector<double>& parameters);

}  // namespace hariko
