#pragma once

// Necks and holes that are about to open: made wide enough for patches (docs/envelope.md).

#include <cstddef>
#include <optional>

#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

/// Lowers the field about its saddles that lie within a tenth of `sigma` of zero, to 0.1 `sigma` below it:
/// the surface has hardly any slope there, and would bend without bound. A neck thinner than that is there
/// or is not, a hole narrower than that is closed. The field is lowered only, so what was inside stays there.
/// `mirror`: the plane across this axis, at `plane` from the field's zero, is one of symmetry. The number of
/// saddles. O(nodes).
std::size_t close_pinches(SplineField& field, double sigma, std::optional<Eigen::Index> mirror = {},
                          double plane = 0);

}  // namespace hariko
