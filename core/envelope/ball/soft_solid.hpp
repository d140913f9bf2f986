#pragma once

// Softened solids, which give a single solid its own roundness (docs/envelope.md).

#include "core/envelope/solid.hpp"

namespace hariko {

/// Returns the solid with all faces moved inwards by its own roundness times 0.95 of the radius of an
/// inscribed ball: a surface that follows it at a larger distance has rounder edges. Solids without edges,
/// and those without a roundness of their own, are returned unchanged.
Solid softened(const Solid& solid);

}  // namespace hariko
