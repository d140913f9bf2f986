#pragma once

// Loose Bezier patches become one surface where their sides meet.

#include "core/surface/surface.hpp"
#include "core/surface/tensor_bezier.hpp"

namespace hariko {

/// Patches are welded where their sides are the same curve with the same or the reversed parameter, to 2e-8
/// of the whole's size, or to what rounds numbers that far from zero; a side that is a part of a longer side,
/// with a parameter that is linear in the longer one's, becomes a T-joint. Patches that look the other way
/// than their neighbours are flipped; the first of each connected part keeps its direction. Where a strip
/// closes with a twist it stays open. Seams are G1 where tangent planes agree to 1e-6 rad, else G0.
/// Provenance: face k for patch k; edges have no source. Positions are relative to `origin`. Errors: those of
/// `check_patch`. O(n log n) patches, and pairs of sides that stay free whose boxes lie in each other.
Result<Surface> weld_patches(const Vector3& origin, std::vector<BezierPatch> patches);

}  // namespace hariko
