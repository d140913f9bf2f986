#pragma once

// Patches over a cage that follow the surface where a field is zero, curvature included (docs/envelope.md).

#include <vector>

#include "core/envelope/ball/ball_cage.hpp"
#include "core/envelope/ball/hermite_patch.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Everything about a patch depends on the field near its quad alone.
std::vector<HermitePatch> ball_patches(const SplineField& field, const BallCage& cage);

/// How far a patch is from the surface, by samples.
struct PatchFit {
  double outward = 0, inward = 0;  ///< lengths, each at least 0
  double least_agreement = 1;      ///< of normals: cosine of the largest angle
  std::array<double, 2> turn{};  ///< of the surface's normal along sides 0 and 2, and along 1 and 3; radians
};
/// `intervals`: of the samples along a side.
std::vector<PatchFit> patch_fits(const SplineField& field, std::span<const HermitePatch> patches,
                                 int intervals = 8);

/// Face k of the cage is the source of patch k.
Surface ball_surface(const SplineField& field, const BallCage& cage, std::vector<HermitePatch> patches,
                     const Vector3& origin);

}  // namespace hariko
