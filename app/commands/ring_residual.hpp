#pragma once

// Residual of the G1 conditions round a vertex for plain quartic patches.

#include "core/document/source.hpp"
#include "core/patching/quartic/quartic_patch.hpp"

namespace hariko {

/// Largest |y . R| / |y| over all even rings: those round split points of faces with an even number of sides
/// and round inner vertices without creases. y is the left null vector of the ring's conditions, R their
/// right-hand sides relative to the ring's centre. Zero means that ordinary quartics would suffice. `patches`
/// are those of `source`, one for each half-edge. O(half-edges).
double largest_ring_residual(const PolyhedronSource& source, const QuarticPatchSet& patches);

}  // namespace hariko
