#pragma once

// Cleanup of the shaping of a polyhedron after its connectivity has changed.

#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko::detail {

/// Returns `shaping` without the entries of elements that `after` does not have and without `corner` tags at
/// inner vertices with fewer than two creases. Pinned tangents stay where the fan of the vertex (its edges in
/// order, and which of them are sharp) is that of `before` under `shaping_before`; elsewhere two tangents
/// become a pin of their plane, and others are dropped. O(n log n).
Shaping shaping_on(const Polyhedron& after, const Shaping& shaping, const Polyhedron& before,
                   const Shaping& shaping_before);

}  // namespace hariko::detail
