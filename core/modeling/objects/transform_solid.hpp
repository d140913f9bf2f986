#pragma once

// Moving, rotating and stretching a solid.

#include "core/envelope/solid.hpp"
#include "core/modeling/objects/transformation.hpp"

namespace hariko {

/// Returns the solid transformed about `pivot`. Translations, and rotations and stretches along the solid's
/// own axes, are exact. A stretch that would shear the solid is replaced by the nearest rotation and the
/// lengths that its axes get, so that it keeps right angles.
Solid transformed(Solid solid, const Transformation& transformation, const Vector3& pivot);

}  // namespace hariko
