#pragma once

// Roundness of a single solid (docs/envelope.md).

#include "core/envelope/solid.hpp"

namespace hariko {

/// The solid with all faces moved inwards by its own roundness times 0.95 of the radius of a ball that it
/// holds: what a surface follows instead of it, at a larger distance, has rounder edges. Solids without
/// edges, and those without a roundness of their own, are returned as they are.
Solid softened(const Solid& solid);

}  // namespace hariko
