#include "core/modeling/measuring/surface_spot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/index_list.hpp"

namespace hariko {

namespace {

constexpr std::uint32_t next_with_these_names = 1U << 16;
constexpr int grid_density = 4;
constexpr Index patches_at_a_time = 256;
constexpr std::size_t most_candidates = 6;
constexpr int most_steps = 40;

struct Candidate {
  double distance = 0;  ///< squared
  SurfaceSpot spot;
};

/// Nearest point of the domain.
Vector2 within_domain(Domain domain, Vector2 parameter) {
  if (domain == Domain::square) return parameter.cwiseMax(0).cwiseMin(1);
  const double beyond = parameter.sum() - 1;
  if (beyond > 0) parameter.array() -= beyond / 2;
  parameter = parameter.cwiseMax(0).cwiseMin(1);
  if (parameter.sum() > 1) parameter /= parameter.sum();
  return parameter;
}

/// The best points of a grid, one a patch, nearest first.
std::vector<Candidate> candidates_for(const Surface& surface, const Vector3& point) {
  const GridPattern pattern{surface.domain(), grid_density};
  const std::vector<Vector2> parameters = pattern.parameters();
  const auto n = static_cast<std::size_t>(pattern.point_count());
  std::vector<Candidate> best;
  std::vector<Vector3> positions, normals;
  for (Index first = 0; first < surface.patch_count(); first += patches_at_a_time) {
    const std::vector<Index> patches =
        ascending_indices(std::min(patches_at_a_time, surface.patch_count() - first), first);
    positions.resize(patches.size() * n);
    normals.resize(patches.size() * n);
    surface.patches().evaluate_grid(patches, pattern, positions, normals);
    for (std::size_t p = 0; p < patches.size(); ++p) {
      Candidate here{std::numeric_limits<double>::infinity(), {patches[p], {}}};
      for (std::size_t i = 0; i < n; ++i) {
        const double distance = (positions[p * n + i] - point).squaredNorm();
        if (distance < here.distance) here = {distance, {patches[p], parameters[i]}};
      }
      if (best.size() == most_candidates && !(here.distance < best.back().distance)) continue;
      const auto place =
          std::upper_bound(best.begin(), best.end(), here,
                           [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
      best.insert(place, here);
      if (best.size() > most_candidates) best.pop_back();
    }
  }
  return best;
}

/// Step towards the nearest point: Newton's where the distance is convex, otherwise that of Gauss and Newton,
/// without the second derivatives. Nothing where the tangents are parallel.
std::optional<Vector2> step_towards(const PatchPoint& here, const Vector3& point) {
  const Vector3 away = here.position - point;
  const Vector2 gradient(here.ds.dot(away), here.dt.dot(away));
  const double a = here.ds.squaredNorm(), b = here.ds.dot(here.dt), c = here.dt.squaredNorm();
  const auto solved = [&](double ss, double st, double tt) -> std::optional<Vector2> {
    const double determinant = ss * tt - st * st;
    if (!(ss > 0 && determinant > 1e-24 * a * c)) return std::nullopt;
    return Vector2(st * gradient.y() - tt * gradient.x(), st * gradient.x() - ss * gradient.y()) /
           determinant;
  };
  if (const auto step = solved(a + here.dss.dot(away), b + here.dst.dot(away), c + here.dtt.dot(away)))
    return step;
  return solved(a, b, c);
}

/// Steps on one patch, each no longer than it brings the point nearer.
Candidate improved(const Surface& surface, Candidate at, const Vector3& point) {
  for (int step = 0; step < most_steps; ++step) {
    const auto full =
        step_towards(surface.patches().evaluate(at.spot.patch, at.spot.parameter, Order::second), point);
    if (!full) break;
    bool nearer = false;
    for (double share = 1; share > 1e-4 && !nearer; share /= 2) {
      const Vector2 next = within_domain(surface.domain(), at.spot.parameter + share * *full);
      const double distance =
          (surface.patches().evaluate(at.spot.patch, next, Order::first).position - point).squaredNorm();
      if (!(distance < at.distance)) continue;
      nearer = (next - at.spot.parameter).norm() > 1e-14;
      at.distance = distance;
      at.spot.parameter = next;
    }
    if (!nearer) break;
  }
  return at;
}

}  // namespace

std::optional<SurfaceSpot> spot_of(const Surface& surface, const PatchAnchor& anchor) {
  const std::uint32_t side = anchor.side % next_with_these_names;
  std::uint32_t earlier = anchor.side / next_with_these_names;
  for (Index p = 0; p < surface.patch_count(); ++p) {
    const Provenance& from = surface.provenance()[p];
    if (from.side != side || !(from.element == anchor.element)) continue;
    if (earlier == 0) return SurfaceSpot{p, within_domain(surface.domain(), anchor.parameter)};
    --earlier;
  }
  return std::nullopt;
}

PatchAnchor patch_anchor(const Surface& surface, ObjectId object, const SurfaceSpot& spot) {
  const Provenance& from = surface.provenance()[spot.patch];
  PatchAnchor anchor{object, from.element, from.side, spot.parameter};
  for (Index p = 0; p < spot.patch; ++p) {
    const Provenance& other = surface.provenance()[p];
    if (other.side == from.side && other.element == from.element) anchor.side += next_with_these_names;
  }
  return anchor;
}

std::optional<SurfaceSpot> nearest_spot(const Surface& surface, const Vector3& point) {
  if (surface.patch_count() == 0) return std::nullopt;
  std::optional<Candidate> best;
  for (const Candidate& candidate : candidates_for(surface, point)) {
    const Candidate refined = improved(surface, candidate, point);
    if (!best || refined.distance < best->distance) best = refined;
  }
  return best ? std::optional(best->spot) : std::nullopt;
}

}  // namespace hariko
