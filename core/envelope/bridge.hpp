#pragma once

// Bridges: bars between solids.

#include "core/envelope/solid.hpp"

namespace hariko {

/// Makes a capsule of radius `radius` (a length) from one solid to another, in the axes of their object. It
/// ends at their nearest points, shifted slightly towards their centres, so that it moves continuously with
/// the solids even where sides are parallel. It stores the ids of the two.
Solid bridge_between(const Solid& a, const Solid& b, double radius);

}  // namespace hariko
