#pragma once

// A solid moved, turned or stretched.

#include "core/envelope/solid.hpp"
#include "core/modeling/transformation.hpp"

namespace hariko {

/// Moves exactly; turns and stretches along the solid's own axes exactly. What would shear the solid leaves
/// it with right angles: the nearest rotation, and the lengths that its axes get.
Solid transformed(Solid solid, const Transformation& transformation, const Vector3& pivot);

}  // namespace hariko
