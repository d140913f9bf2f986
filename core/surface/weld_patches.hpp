#pragma once

// Welding of loose Bezier patches into one surface where their sides meet.

#include "core/surface/surface.hpp"
#include "core/surface/tensor_bezier.hpp"

namespace hariko {

/// Welds patches where their sides are the same curve with the same or the reversed parameter, within 2e-8 of
/// the size of the whole, or within the rounding of coordinates so far from zero; a side that is a part of a
/// longer side, with a parameter that is linear in the longer one's, becomes a T-joint. Where more than two
/// sides are one curve, as where bodies touch, those that run in opposite directions are paired. Patches
/// oriented against their neighbours are flipped; the first patch of each connected part keeps its
/// orientation. Where a strip closes with a twist it stays open. Seams are G1 where tangent planes agree to
/// 1e-6 rad, otherwise G0. Provenance: face k for patch k; edges have no source. Positions are relative to
/// `origin`. Errors: those of `check_patch`. O(n log n) in patches, plus the pairs of unmatched sides whose
/// boxes overlap.
Result<Surface> weld_patches(const Vector3& origin, std::vector<BezierPatch> patches);

}  // namespace hariko
