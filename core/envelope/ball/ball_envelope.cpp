#include "core/envelope/ball/ball_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/envelope/ball/ball_patches.hpp"
#include "core/envelope/ball/pinches.hpp"

namespace hariko {

namespace {

constexpr double least_ball = 3;  ///< smallest ball radius, in sigma
/// Smallest rounding relative to the solids' size: lattices of finer roundings would not fit into memory.
constexpr double least_rounding = 1.0 / 160;
/// Radius relative to the solids' size of the ball for the hull; its envelope differs from the hull by
/// 1/16000 of the size.
constexpr double hull_ball = 2000;
/// Largest deviation of samples relative to the tolerance, because patches may deviate more between samples.
constexpr double sample_margin = 0.9;
constexpr double cube_share = 2;     ///< edge of cubes of one size, in sigma
constexpr double finer_share = 0.7;  ///< factor of the edges for finer patches
/// Number of points on the surface of a solid that are tested for protrusion.
constexpr int spread_points = 200;
constexpr int least_curve_points = 8, most_curve_points = 400;  ///< number of such points on an edge or a rim
constexpr int foot_steps = 8;
constexpr int most_cuts = 3, final_rounds = 3, drag_rounds = 1;
constexpr int fit_intervals = 8, drag_intervals = 4;  ///< number of sample intervals along a side of a patch
constexpr double least_agreement = 0.77;              ///< cosine of 40 degrees
/// Radians: a quad over which the surface turns more misses a part of it.
constexpr double largest_turn = 2.2;
/// Fraction of the largest turn: a patch that turns as much in the other direction too is cut both ways.
constexpr double even_turn = 0.6;

bool is_good(const PatchFit& fit, double tolerance) {
  return std::max(fit.outward, fit.inward) <= sample_margin * tolerance &&
         fit.least_agreement >= least_agreement;
}

/// Cuts of a patch across the direction along which the surface turns most.
QuadCuts cuts_of(const PatchFit& fit) {
  const double most = std::max(fit.turn[0], fit.turn[1]);
  return {fit.turn[0] >= even_turn * most, fit.turn[1] >= even_turn * most};
}

/// Patches over a cage, with their deviations.
struct Fitted {
  BallCage cage;
  std::vector<HermitePatch> patches;
  std::vector<PatchFit> fits;
  std::size_t coarse = 0;  ///< number of patches that deviate too much
  int rounds = 0;          ///< number of rounds in which quads or cubes were split

  Fitted(const SplineField& field, BallCage of, double tolerance, int intervals)
      : cage(std::move(of)), patches(ball_patches(field, cage)), fits(patch_fits(field, patches, intervals)) {
    for (const PatchFit& fit : fits) coarse += !is_good(fit, tolerance);
  }
  double turn() const {
    double out = 0;
    for (const PatchFit& fit : fits) out = std::max({out, fit.turn[0], fit.turn[1]});
    return out;
  }
};

class Fitting {
 public:
  Fitting(const SplineField& field, const Vector3& origin, const BallSettings& settings, Quality quality,
          const CancelToken& cancel)
      : field_(field),
        origin_(origin),
        edge_((settings.finer_patches ? finer_share : 1) * cube_share * settings.sigma),
        tolerance_(patch_tolerance * settings.sigma),
        intervals_(quality == Quality::drag ? drag_intervals : fit_intervals),
        most_rounds_(quality == Quality::drag ? drag_rounds : final_rounds),
        cancel_(cancel) {}

  /// Tries cubes of one size first, which need the fewest patches; then cubes of several sizes, if the first
  /// miss part of the surface or patches deviate too much.
  std::optional<Fitted> run() const {
    std::optional<Fitted> best;
    if (CubeTree cubes = surface_cubes(field_, origin_, edge_); !cubes.any_split())
      best = cut_where_needed(over(cubes));
    if (!best || best->coarse > 0) {
      Fitted halved = halved_where_needed();
      if (!best || halved.coarse < best->coarse) best = std::move(halved);
    }
    if (best->cage.quads.empty()) return {};
    return best;
  }

 private:
  Fitted over(CubeTree& cubes) const { return {field_, ball_cage(field_, cubes), tolerance_, intervals_}; }

  /// Cuts the patches that deviate too much, as long as that helps.
  Fitted cut_where_needed(Fitted of) const {
    while (of.coarse > 0 && of.rounds < most_cuts && of.turn() <= largest_turn && !cancel_.cancelled()) {
      std::vector<QuadCuts> cuts;
      for (const PatchFit& fit : of.fits)
        cuts.push_back(is_good(fit, tolerance_) ? QuadCuts{false, false} : cuts_of(fit));
      Fitted next(field_, cut_cage(field_, of.cage, of.patches, cuts, 0.25 * edge_), tolerance_, intervals_);
      if (next.coarse >= 2 * of.coarse) break;
      next.rounds = of.rounds + 1;
      of = std::move(next);
    }
    return of;
  }

  /// Splits the cubes below patches that deviate too much, as long as there are any and levels are left.
  /// Begins with cubes twice as large, because sides of patches are half as long as theirs.
  Fitted halved_where_needed() const {
    CubeTree cubes = surface_cubes(field_, origin_, 2 * edge_);
    Fitted last = over(cubes), best = last;
    for (int round = 1; round <= most_rounds_ && last.coarse > 0 && !cancel_.cancelled(); ++round) {
      bool any = false;
      for (std::size_t q = 0; q < last.fits.size(); ++q) {
        const Cube& cube = last.cage.cubes[q];
        if (is_good(last.fits[q], tolerance_) || cube.level >= cubes.depth()) continue;
        any = true;
        cubes.split(cube);
      }
      if (!any) break;
      last = over(cubes);
      last.rounds = round;
      if (last.coarse < best.coarse) best = last;
    }
    return best;
  }

  const SplineField& field_;
  const Vector3& origin_;
  double edge_, tolerance_;
  int intervals_, most_rounds_;
  const CancelToken& cancel_;
};

/// Balls of bridges with a radius of their own: between the bar, its two solids and the images of these.
std::vector<OwnBall> own_balls(std::span<const Solid> solids, double sigma) {
  std::vector<OwnBall> out;
  std::set<std::uint32_t> done;
  for (const Solid& bar : solids) {
    if (!bar.bridge || !bar.bridge->ball_radius || !done.insert(bar.id).second) continue;
    OwnBall own{std::max(*bar.bridge->ball_radius, least_ball * sigma), {}};
    for (const Solid& solid : solids)
      own.between.push_back(solid.id == bar.id || std::ranges::count(bar.bridge->between, solid.id) > 0);
    out.push_back(std::move(own));
  }
  return out;
}

}  // namespace

double room_outside(const BallSettings& settings) {
  return settings.clearance + (settings.on_faces ? 0 : patch_tolerance * settings.sigma);
}

double sticking_out(const SplineField& field, std::span<const SolidShape> solids, double sigma) {
  double out = 0;
  const auto look_at = [&](const Vector3& p) {
    if (field.value(p) > 0) out = std::max(out, (projected(field, p, foot_steps, sigma) - p).norm());
  };
  for (const SolidShape& solid : solids) {
    for (const Vector3& p : solid.surface_points(spread_points)) look_at(p);
    for (const Vector3& p : solid.extremes()) look_at(solid.from_own_axes(p));
    for (const SharpCurve& curve : solid.sharp_curves()) {
      const int count = std::clamp(int(4 * curve.length() / sigma), least_curve_points, most_curve_points);
      for (int k = 0; k <= count; ++k) look_at(curve.at(double(k) / count));
    }
  }
  return out;
}

BallSettings ball_settings(const EnvelopeSettings& settings, double size) {
  BallSettings out;
  out.sigma = std::max(settings.rounding, least_rounding * size);
  out.radius = std::max(settings.ball_radius.value_or(hull_ball * size), least_ball * out.sigma);
  out.clearance = settings.clearance;
  out.on_faces = settings.on_faces;
  out.finer_patches = settings.finer_patches;
  return out;
}

BallField ball_field(std::span<const Solid> solids, const BallSettings& settings, const Vector3& origin,
                     std::optional<Eigen::Index> mirror, Quality quality, const CancelToken& cancel) {
  std::vector<GrownSolid> grown;
  for (const Solid& solid : solids)
    grown.push_back(grown_solid(solid, origin, settings.sigma, room_outside(settings), settings.on_faces));
  const GrownUnion all(std::move(grown));
  LatticeRequest request{all};
  request.radius = settings.radius;
  request.sigma = settings.sigma;
  request.passes = quality == Quality::drag ? drag_passes : final_passes;
  request.origin = origin;
  request.mirror = mirror;
  request.own_balls = own_balls(solids, settings.sigma);
  BallField out;
  out.field = smoothed_closing(request, &out.lattice, cancel);
  if (!cancel.cancelled())
    out.pinches = close_pinches(out.field, settings.sigma, mirror, mirror ? -origin[*mirror] : 0);
  return out;
}

BallCage cage_of(const BallField& field, const Vector3& origin, double sigma) {
  CubeTree cubes = surface_cubes(field.field, origin, cube_share * sigma);
  return ball_cage(field.field, cubes);
}

std::optional<BallEnvelope> ball_envelope(std::span<const Solid> solids, const BallSettings& settings,
                                          const Vector3& origin, std::optional<Eigen::Index> mirror,
                                          Quality quality, const CancelToken& cancel) {
  BallEnvelope out;
  out.tolerance = patch_tolerance * settings.sigma;
  static_cast<BallField&>(out) = ball_field(solids, settings, origin, mirror, quality, cancel);
  if (cancel.cancelled()) return {};
  std::optional<Fitted> made = Fitting(out.field, origin, settings, quality, cancel).run();
  if (cancel.cancelled() || !made) return {};
  out.cage = std::move(made->cage);
  out.topology = topology_of(out.cage);
  if (settings.on_faces) {
    std::vector<SolidShape> shapes;
    for (const Solid& solid : solids) shapes.emplace_back(solid, origin);
    out.sticks_out = sticking_out(out.field, shapes, settings.sigma);
  }
  out.rounds = made->rounds;
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
