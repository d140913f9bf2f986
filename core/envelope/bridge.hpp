#pragma once

// Bars between solids.

#include "core/envelope/solid.hpp"

namespace hariko {

/// A capsule of radius `radius` (a length) from one solid to another, in the axes of their object. It ends
/// where they are nearest to each other, drawn a little towards their middles: so it goes with the solids
/// steadily, also where sides lie opposite to each other. It knows the ids of the two.
Solid bridge_between(const Solid& a, const Solid& b, double radius);

}  // namespace hariko
