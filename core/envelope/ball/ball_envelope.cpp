#include "core/envelope/ball/ball_envelope.hpp"

#include <algorithm>
#include <cmath>

#include "core/envelope/ball/ball_patches.hpp"

namespace hariko {

namespace {

constexpr double tolerance_share = 0.1;  ///< of sigma
constexpr double sample_margin = 0.9;    ///< of the tolerance: patches may be farther off between samples
constexpr double cell_share = 2;         ///< of sigma
constexpr double finer = 0.8;            ///< from one size of cells to the next
constexpr int most_sizes = 5, drag_sizes = 2;
constexpr int most_cuts = 3;
constexpr double least_agreement = 0.77;  ///< cosine of 40 degrees
constexpr double largest_turn =
    2.2;  ///< radians: a quad over which the surface turns more misses a part of it
/// Share of the largest turn: a patch that turns as much along its other way too is halved both ways.
constexpr double even_turn = 0.6;

bool fits(const PatchFit& fit, double tolerance) {
  return std::max(fit.outward, fit.inward) <= sample_margin * tolerance &&
         fit.least_agreement >= least_agreement;
}

/// Across the way along which the surface turns most.
QuadCuts cuts_of(const PatchFit& fit) {
  const double most = std::max(fit.turn[0], fit.turn[1]);
  return {fit.turn[0] >= even_turn * most, fit.turn[1] >= even_turn * most};
}

struct Fitted {
  BallCage cage;
  std::vector<HermitePatch> patches;
  std::vector<PatchFit> fits;
  std::size_t coarse = 0;  ///< patches that do not fit
  int cuts = 0;

  Fitted(const SplineField& field, BallCage of, double tolerance)
      : cage(std::move(of)), patches(ball_patches(field, cage)), fits(patch_fits(field, patches)) {
    coarse = std::size_t(
        std::ranges::count_if(fits, [&](const PatchFit& f) { return !hariko::fits(f, tolerance); }));
  }
  double turn() const {
    double out = 0;
    for (const PatchFit& fit : fits) out = std::max({out, fit.turn[0], fit.turn[1]});
    return out;
  }
};

/// Halves the patches that do not fit, as long as that helps.
Fitted cut_where_needed(const SplineField& field, Fitted of, double tolerance) {
  while (of.coarse > 0 && of.cuts < most_cuts && of.turn() <= largest_turn) {
    std::vector<QuadCuts> cuts;
    for (const PatchFit& fit : of.fits)
      cuts.push_back(fits(fit, tolerance) ? QuadCuts{false, false} : cuts_of(fit));
    Fitted next(field, cut_cage(field, of.cage, of.patches, cuts), tolerance);
    if (next.coarse >= 2 * of.coarse) break;
    next.cuts = of.cuts + 1;
    of = std::move(next);
  }
  return of;
}

/// The largest cells with which all patches fit, or the best there is.
std::optional<Fitted> fitted(const SplineField& field, const Vector3& origin, double sigma, int sizes,
                             const CancelToken& cancel) {
  std::optional<Fitted> best;
  double cell = cell_share * sigma;
  for (int size = 0; size < sizes && !cancel.cancelled(); ++size, cell *= finer) {
    BallCage cage = ball_cage(field, origin, cell);
    if (cage.quads.empty()) continue;
    Fitted one = cut_where_needed(field, Fitted(field, std::move(cage), tolerance_share * sigma),
                                  tolerance_share * sigma);
    if (!best || one.coarse < best->coarse) best = std::move(one);
    if (best->coarse == 0) break;
  }
  return best;
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
  const GrownUnion all(std::move(grown));
  const bool drag = quality == Quality::drag;
  LatticeRequest request{all};
  request.radius = settings.radius;
  request.sigma = settings.sigma;
  request.passes = drag ? drag_passes : final_passes;
  request.origin = origin;
  request.mirror = mirror;
  out.field = smoothed_closing(request, &out.lattice, cancel);
  if (cancel.cancelled()) return {};
  std::optional<Fitted> made =
      fitted(out.field, origin, settings.sigma, drag ? drag_sizes : most_sizes, cancel);
  if (cancel.cancelled() || !made) return {};
  out.cage = std::move(made->cage);
  out.topology = topology_of(out.cage);
  out.cuts = made->cuts;
  out.coarse = made->coarse;
  for (const PatchFit& fit : made->fits) {
    out.outward = std::max(out.outward, fit.outward);
    out.inward = std::max(out.inward, fit.inward);
    out.folds += fit.least_agreement < 0;
  }
  out.surface = ball_surface(out.field, out.cage, std::move(made->patches), origin);
  return out;
}

}  // namespace hariko
