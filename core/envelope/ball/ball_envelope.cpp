#include "core/envelope/ball/ball_envelope.hpp"

#include <algorithm>
#include <cmath>

#include "core/envelope/ball/ball_patches.hpp"

namespace hariko {

namespace {

constexpr double tolerance_share = 0.1;   ///< of sigma
constexpr double sample_margin = 0.9;     ///< of the tolerance: patches may be farther off between samples
constexpr double cell_share = 2;          ///< of sigma
constexpr double least_agreement = 0.77;  ///< cosine of 40 degrees
constexpr double even_turn = 0.6;  ///< where a patch turns this much of the most along its other way too, it
                                   ///< is halved both ways
constexpr int final_cuts = 4, drag_cuts = 1;

bool fits(const PatchFit& fit, double tolerance) {
  return std::max(fit.outward, fit.inward) <= sample_margin * tolerance &&
         fit.least_agreement >= least_agreement;
}

/// Across the way along which the surface turns most.
QuadCuts cuts_of(const PatchFit& fit) {
  const double most = std::max(fit.turn[0], fit.turn[1]);
  return {fit.turn[0] >= even_turn * most, fit.turn[1] >= even_turn * most};
}

}  // namespace

std::optional<BallEnvelope> ball_envelope(std::span<const Solid> solids, const BallSettings& settings,
                                          const Vector3& origin, std::optional<Eigen::Index> mirror,
                                          Quality quality, const CancelToken& cancel) {
  BallEnvelope out;
  out.tolerance = tolerance_share * settings.sigma;
  std::vector<GrownSolid> grown;
  for (const Solid& solid : solids) {
    SolidShape shape(solid, origin);
    const double growth = growth_constant(shape, settings.sigma) + settings.clearance + out.tolerance;
    grown.push_back({std::move(shape), growth});
  }
  const GrownSolids all(std::move(grown));
  const bool drag = quality == Quality::drag;
  LatticeRequest request{all};
  request.radius = settings.radius;
  request.sigma = settings.sigma;
  request.passes = drag ? drag_passes : final_passes;
  request.origin = origin;
  request.mirror = mirror;
  out.field = smoothed_closing(request, &out.lattice, cancel);
  if (cancel.cancelled()) return {};
  out.cage = ball_cage(out.field, origin, cell_share * settings.sigma);
  if (out.cage.quads.empty()) return {};
  out.topology = topology_of(out.cage);
  std::vector<HermitePatch> patches = ball_patches(out.field, out.cage);
  std::vector<PatchFit> found = patch_fits(out.field, patches);
  const int most_cuts = drag ? drag_cuts : final_cuts;
  for (; out.cuts < most_cuts && !cancel.cancelled(); ++out.cuts) {
    std::vector<QuadCuts> cuts;
    for (const PatchFit& fit : found)
      cuts.push_back(fits(fit, out.tolerance) ? QuadCuts{false, false} : cuts_of(fit));
    if (std::ranges::none_of(cuts, [](const QuadCuts& cut) { return cut[0] || cut[1]; })) break;
    out.cage = cut_cage(out.field, out.cage, cuts);
    patches = ball_patches(out.field, out.cage);
    found = patch_fits(out.field, patches);
  }
  if (cancel.cancelled()) return {};
  for (const PatchFit& fit : found) {
    out.outward = std::max(out.outward, fit.outward);
    out.inward = std::max(out.inward, fit.inward);
    out.folds += fit.least_agreement < 0;
    out.coarse += !fits(fit, out.tolerance);
  }
  out.surface = ball_surface(out.field, out.cage, std::move(patches), origin);
  return out;
}

}  // namespace hariko
