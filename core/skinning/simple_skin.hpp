#pragma once

// A skin to begin with.

#include "core/skinning/skin.hpp"

namespace hariko {

/// Two arches across y at both ends of a straight path along x, all centred about zero: `length` apart,
/// `width` wide, `height` high at the first and half as high at the second; `points` control points each (3
/// or more). Pleated.
Skin arched_skin(double length, double width, double height, int points);

}  // namespace hariko
