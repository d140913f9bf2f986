#pragma once

// Parameters at which the columns of a grid meet the sections, chosen so that curves through those points
// approximate the sections.

#include <functional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/subdivision/subdivision_curve.hpp"

namespace hariko {

/// Evenly spaced parameters: from 0 to 1 for open sections, from 0 below 1 for closed ones.
std::vector<double> uniform_parameters(int columns, bool closed);

/// Parameters u_0 < u_1 < ... that minimise the squared distance, summed over the sections, between each
/// section and the subdivision curve through its points at them. Open: from 0 to 1; closed: within one turn,
/// the first anywhere near 0. The widths are a softmax of the unknowns, so that the order is always kept.
/// Levenberg-Marquardt from five seeds (uniform, arc length, curvature, and on control points of the
/// sections, denser at one end or at the other), at most 60 evaluations each; the best result wins. The
/// curves have many local minima: the first three seeds alone, those of the original method, end in worse
/// ones (docs/skinning.md). `step` is called after each of the `optimiser_seeds` seeds. When cancelled,
/// returns the best result so far. `starts`, one per section or empty: parameters of closed sections that u
/// counts from.
std::vector<double> optimised_parameters(const std::vector<SubdivisionCurve>& sections, int columns,
                                         const CancelToken& cancel = {},
                                         const std::function<void()>& step = {},
                                         const std::vector<double>& starts = {});
inline constexpr std::size_t optimiser_seeds = 5;

/// Root mean square of the distance that is minimised.
double parameter_error(const std::vector<SubdivisionCurve>& sections, const std::vector<double>& parameters);

}  // namespace hariko
