#pragma once

// Pinches, necks and holes about to open, widened so that patches can follow the surface (docs/envelope.md).

#include <cstddef>
#include <optional>

#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

/// Lowers the field near its saddles that lie within a tenth of `sigma` of zero, to 0.1 `sigma` below it:
/// there the surface has hardly any slope, and its curvature would be unbounded. A thinner neck is kept or
/// absent, a narrower hole is closed. The field is only lowered, so that no inside point becomes outside.
/// `mirror`: the plane perpendicular to this axis, at `plane` from the field's origin, is a symmetry plane.
/// Returns the number of saddles. O(nodes).
std::size_t close_pinches(SplineField& field, double sigma, std::optional<Eigen::Index> mirror = {},
                          double plane = 0);

}  // namespace hariko
