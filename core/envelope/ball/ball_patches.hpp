#pragma once

// Patches over a quad mesh that approximate the zero surface of a field, including its curvature
// (docs/envelope.md).

#include <memory>
#include <vector>

#include "core/envelope/ball/ball_cage.hpp"
#include "core/envelope/ball/hermite_patch.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Makes the patches. Each depends on the field near its quad alone.
std::shared_ptr<const HermitePatchSet> ball_patches(const SplineField& field, const BallCage& cage);

/// Deviation of a patch from the surface, at sampled points.
struct PatchFit {
  double outward = 0, inward = 0;  ///< lengths, each at least 0
  double least_agreement = 1;      ///< least cosine of the angle between the normals of patch and field
};
/// Measures the deviations. `intervals`: number of sample intervals along a side.
std::vector<PatchFit> patch_fits(const SplineField& field, const HermitePatchSet& patches, int intervals = 8);

/// Angles over which the field's normals turn along sides 0 and 2 of a patch, and along 1 and 3; radians.
using PatchTurn = std::array<double, 2>;
/// Measures the turns. `intervals` as above.
std::vector<PatchTurn> patch_turns(const SplineField& field, const HermitePatchSet& patches,
                                   int intervals = 8);

/// Makes the surface. Patch k has face k of the cage as provenance.
Surface ball_surface(const SplineField& field, const BallCage& cage,
                     std::shared_ptr<const HermitePatchSet> patches, const Vector3& origin);

}  // namespace hariko
