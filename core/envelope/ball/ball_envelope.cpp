#include "core/envelope/ball/ball_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/envelope/ball/ball_patches.hpp"
#include "core/geometry/winding_tree.hpp"

namespace hariko {

namespace {

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
constexpr int foot_steps = 8, foot_rounds = 4;
constexpr int most_cuts = 3, final_rounds = 6, drag_rounds = 1;
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
QuadCuts cuts_of(const PatchTurn& turn) {
  const double most = std::max(turn[0], turn[1]);
  return {turn[0] >= even_turn * most, turn[1] >= even_turn * most};
}

/// Points that lie outside a cage.
std::vector<Vector3> points_outside(const BallCage& cage, std::span<const Vector3> points) {
  std::vector<std::array<Index, 3>> triangles;
  for (const auto& [a, b, c, d] : cage.quads) triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
  if (triangles.empty()) return {points.begin(), points.end()};
  const WindingTree tree(cage.positions, triangles);
  std::vector<Vector3> out;
  for (const Vector3& p : points)
    if (tree.winding(p) < 0.5) out.push_back(p);
  return out;
}

/// Leaves round points: several where a point lies between them, so that both sides of a plane of symmetry
/// are split alike.
std::vector<Cube> cubes_about(const CubeTree& cubes, std::span<const Vector3> points) {
  const double beside = 1e-6 * cubes.edge(cubes.depth());
  std::vector<Cube> out;
  for (const Vector3& p : points)
    for (int c = 0; c < 8; ++c)
      out.push_back(cubes.leaf_at(p + beside * Vector3(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1)));
  return out;
}

/// Patches over a cage, with their deviations.
struct Fitted : BallFit {
  BallCage cage;
  std::shared_ptr<const HermitePatchSet> patches;
  std::vector<PatchFit> fits;
  std::vector<Vector3> lost;  ///< middles of solids outside of the cage

  Fitted(const BallField& field, BallCage of, double tolerance, int intervals)
      : cage(std::move(of)),
        patches(ball_patches(field.field, cage)),
        fits(patch_fits(field.field, *patches, intervals)),
        lost(points_outside(cage, field.middles)) {
    for (const PatchFit& fit : fits) {
      inward = std::max(inward, fit.inward);
      outward = std::max(outward, fit.outward);
      folds += fit.least_agreement < 0;
      coarse += !is_good(fit, tolerance);
    }
  }
  bool is_good_throughout() const { return coarse == 0 && lost.empty(); }
};

class Fitting {
 public:
  Fitting(const BallField& field, const Vector3& origin, const BallSettings& settings, Quality quality,
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
    if (CubeTree cubes = surface_cubes(field_.field, origin_, edge_); !cubes.any_split())
      best = cut_where_needed(over(cubes));
    if (!best || !best->is_good_throughout()) {
      Fitted halved = halved_where_needed();
      if (!best || is_better(halved, *best)) best = std::move(halved);
    }
    if (best->cage.quads.empty()) return {};
    return best;
  }

 private:
  Fitted over(CubeTree& cubes) const {
    return {field_, ball_cage(field_.field, cubes), tolerance_, intervals_};
  }

  /// Order of candidates: containing the solids comes first, then no folds, then few patches that deviate, as
  /// one patch that cuts off a tip is worse than ten that lie a little too far outside.
  bool is_better(const Fitted& a, const Fitted& b) const {
    const auto badness = [&](const Fitted& of) {
      return std::tuple(of.lost.size(), std::max(of.inward, tolerance_), of.folds,
                        std::max(of.outward, tolerance_), of.coarse);
    };
    return badness(a) < badness(b);
  }

  /// Cuts the patches that deviate too much, as long as that helps.
  Fitted cut_where_needed(Fitted of) const {
    while (of.coarse > 0 && of.rounds < most_cuts && !cancel_.cancelled()) {
      const std::vector<PatchTurn> turns = patch_turns(field_.field, *of.patches, intervals_);
      double most = 0;
      for (const PatchTurn& turn : turns) most = std::max({most, turn[0], turn[1]});
      if (most > largest_turn) break;
      std::vector<QuadCuts> cuts;
      for (std::size_t q = 0; q < of.fits.size(); ++q)
        cuts.push_back(is_good(of.fits[q], tolerance_) ? QuadCuts{false, false} : cuts_of(turns[q]));
      Fitted next(field_, cut_cage(field_.field, of.cage, *of.patches, cuts, 0.25 * edge_), tolerance_,
                  intervals_);
      if (next.coarse >= 2 * of.coarse) break;
      next.rounds = of.rounds + 1;
      of = std::move(next);
    }
    return of;
  }

  /// Splits the cubes below patches that deviate too much, and those of solids without a surface, as long as
  /// there are any and levels are left. Begins with cubes twice as large, because sides of patches are half
  /// as long as theirs.
  Fitted halved_where_needed() const {
    CubeTree cubes = surface_cubes(field_.field, origin_, 2 * edge_, true);
    Fitted last = over(cubes), best = last;
    for (int round = 1; round <= most_rounds_ && !last.is_good_throughout() && !cancel_.cancelled();
         ++round) {
      bool any = false;
      const auto split = [&](const Cube& cube) {
        any = any || cube.level < cubes.depth();
        cubes.split(cube);
      };
      for (std::size_t q = 0; q < last.fits.size(); ++q)
        if (!is_good(last.fits[q], tolerance_)) split(last.cage.cubes[q]);
      for (const Cube& cube : cubes_about(cubes, last.lost)) split(cube);
      if (!any) break;
      last = over(cubes);
      last.rounds = round;
      if (is_better(last, best)) best = last;
    }
    return best;
  }

  const BallField& field_;
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

/// Distance of a point from the zero surface: from the foot along the gradient, the tangent plane there leads
/// to nearer ones.
static double distance_to_surface(const SplineField& field, const Vector3& p, double sigma) {
  Vector3 foot = projected(field, p, foot_steps, sigma);
  double out = (foot - p).norm();
  for (int round = 0; round < foot_rounds; ++round) {
    const Vector3 normal = field.at(foot).gradient.stableNormalized();
    foot = projected(field, p + (foot - p).dot(normal) * normal, foot_steps, sigma);
    out = std::min(out, (foot - p).norm());
  }
  return out;
}

double sticking_out(const SplineField& field, std::span<const SolidShape> solids, double sigma) {
  double out = 0;
  const auto look_at = [&](const Vector3& p) {
    if (field.value(p) > 0) out = std::max(out, distance_to_surface(field, p, sigma));
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
  const double sigma = std::max(settings.rounding, least_rounding * size);
  const double radius = std::max(settings.ball_radius.value_or(hull_ball * size), least_ball * sigma);
  return {radius, sigma, settings.clearance, settings.on_faces, settings.finer_patches};
}

BallField ball_field(std::span<const Solid> solids, const BallSettings& settings, const Vector3& origin,
                     std::optional<Eigen::Index> mirror, Quality quality, const CancelToken& cancel,
                     BallMemory* memory) {
  KnownSolids own;
  KnownSolids& known = memory ? memory->solids : own;
  std::vector<GrownSolid> grown;
  for (std::size_t i = 0; i < solids.size(); ++i)
    grown.push_back(
        known.grown(i, solids[i], origin, settings.sigma, settings.on_faces, room_outside(settings)));
  BallField out;
  for (const GrownSolid& solid : grown)
    out.middles.push_back(solid.shape.from_own_axes(solid.shape.middle()));
  const GrownUnion all(std::move(grown));
  const LatticeRequest request{all,
                               settings.radius,
                               settings.sigma,
                               quality == Quality::drag ? drag_passes : final_passes,
                               origin,
                               mirror,
                               own_balls(solids, settings.sigma),
                               pulled_places(solids, origin)};
  // Final lattices are larger, and hardly ever follow one another.
  ClosingMemory* const frames = memory && quality == Quality::drag ? &memory->closing : nullptr;
  out.field = smoothed_closing(request, out.lattice, cancel, frames);
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
                                          Quality quality, const CancelToken& cancel, BallMemory* memory) {
  BallEnvelope out;
  out.tolerance = patch_tolerance * settings.sigma;
  static_cast<BallField&>(out) = ball_field(solids, settings, origin, mirror, quality, cancel, memory);
  if (cancel.cancelled()) return {};
  std::optional<Fitted> made = Fitting(out, origin, settings, quality, cancel).run();
  if (cancel.cancelled() || !made) return {};
  out.cage = std::move(made->cage);
  out.topology = topology_of(out.cage);
  if (settings.on_faces) {
    std::vector<SolidShape> shapes;
    for (const Solid& solid : solids) shapes.emplace_back(solid, origin);
    out.sticks_out = sticking_out(out.field, shapes, settings.sigma);
  }
  static_cast<BallFit&>(out) = *made;
  out.lost = made->lost.size();
  out.surface = ball_surface(out.field, out.cage, std::move(made->patches), origin);
  return out;
}

}  // namespace hariko
