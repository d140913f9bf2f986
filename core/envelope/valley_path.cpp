#include "core/envelope/valley_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/envelope/scene_symmetry.hpp"

namespace hariko {

namespace {

constexpr double touching = 1e-9;  ///< of the diagonal
constexpr double facing = 0.30;    ///< half the length of the sum of two gradients
constexpr int bisections = 30, largest_steps = 90, ray_steps = 80;
constexpr double steps_an_edge = 60;

SolidDistance distance_of(const EnvelopeInput& input, const PlacedSolid& placed, const Vector3& origin) {
  Solid solid = input.solids[placed.owner];
  const double clearance = input.settings.clearance;
  const auto stretched = [&](const Vector3& half) -> Vector3 {
    return solid.scale.cwiseProduct(half) + Vector3::Constant(clearance);
  };
  solid.position -= origin;
  switch (solid.kind) {
    case SolidKind::box:
      solid.size = 2 * stretched(solid.size / 2);
      solid.scale = Vector3::Ones();
      break;
    case SolidKind::sphere:
      solid.scale = stretched(Vector3::Constant(solid.radius));
      solid.radius = 1;
      break;
    case SolidKind::cylinder:
    case SolidKind::cone:
      solid.scale = stretched({solid.radius, solid.radius, solid.height / 2});
      solid.radius = 1;
      solid.height = 2;
      break;
    case SolidKind::capsule:
      solid.radius += clearance / solid.scale.maxCoeff();
      break;
    default:
      solid.points.clear();
      for (const Vector3& u : placed.unit_vertices) solid.points.push_back(placed.world(u) - placed.centre);
      solid.kind = SolidKind::polyhedron;
      solid.position = placed.centre;
      solid.rotation = Vector3::Zero();
      solid.scale = Vector3::Ones();
  }
  return SolidDistance(solid, 0, Vector3::Zero());
}

}  // namespace

GrownSolids::GrownSolids(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                         const Vector3& origin)
    : sigma_(input.solids.size(), 1) {
  for (const PlacedSolid& solid : placed)
    if (solid.part % image_part == 0) distances_.push_back(distance_of(input, solid, origin));
}

void GrownSolids::grow(std::span<const PlacedSolid> placed, std::span<const double> sigma) {
  std::fill(sigma_.begin(), sigma_.end(), 1);
  for (std::size_t i = 0; i < placed.size(); ++i)
    sigma_[placed[i].owner] = std::max(sigma_[placed[i].owner], sigma[i]);
}

Vector3 GrownSolids::ungrown(Index solid, const Vector3& x) const {
  const Vector3& c = distances_[solid].centre();
  return c + (x - c) / sigma_[solid];
}

double GrownSolids::distance(Index solid, const Vector3& x) const {
  return sigma_[solid] * distances_[solid](ungrown(solid, x));
}

Vector3 GrownSolids::gradient(Index solid, const Vector3& x) const {
  return distances_[solid].gradient(ungrown(solid, x));
}

ValleyPath valley_path(const GrownSolids& solids, Index solid_a, Index solid_b, const Vector3& a,
                       const Vector3& b, double diagonal) {
  ValleyPath out;
  const double edge = (b - a).norm(), step = edge / steps_an_edge, near = touching * diagonal;
  double low = 0, high = 1;
  for (int round = 0; round < bisections; ++round) {
    const double t = 0.5 * (low + high);
    const Vector3 x = (1 - t) * a + t * b;
    (solids.distance(solid_a, x) < solids.distance(solid_b, x) ? low : high) = t;
  }
  Vector3 x = (1 - low) * a + low * b;
  for (int round = 0; round < largest_steps; ++round) {
    const double da = solids.distance(solid_a, x), db = solids.distance(solid_b, x);
    const Vector3 ga = solids.gradient(solid_a, x), gb = solids.gradient(solid_b, x);
    const Vector3 sum = ga + gb;
    const double half = 0.5 * sum.norm();
    const Vector3 w = half > 0 ? sum.stableNormalized() : ga;
    if (!out.points.empty()) out.length += (x - out.points.back()).norm();
    out.points.push_back(x);
    out.outward.push_back(w);
    if (std::min(da, db) <= near) {
      out.stop = ValleyPath::Stop::landed;
      break;
    }
    for (Index c = 0; c < solids.count() && out.third == no_index; ++c)
      if (c != solid_a && c != solid_b && solids.distance(c, x) <= near) out.third = c;
    if (out.third != no_index) {
      out.stop = ValleyPath::Stop::third;
      break;
    }
    if (half < facing) {
      out.stop = ValleyPath::Stop::open;
      break;
    }
    x -= std::min(step, std::min(da, db) / std::max(half, 0.3)) * w;
    // Back to equal distances.
    const Vector3 across = solids.gradient(solid_b, x) - solids.gradient(solid_a, x);
    if (const double size = across.norm(); size > 0.3) {
      Vector3 move =
          (solids.distance(solid_a, x) - solids.distance(solid_b, x)) / across.squaredNorm() * across;
      if (const double length = move.norm(); length > step) move *= step / length;
      x += move;
    }
  }
  return out;
}

std::pair<Vector3, Vector3> along(const ValleyPath& path, double share) {
  double left = std::clamp(share, 0.0, 1.0) * path.length;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const double length = (path.points[i + 1] - path.points[i]).norm();
    if (left > length) {
      left -= length;
      continue;
    }
    const double t = length > 0 ? left / length : 0;
    return {(1 - t) * path.points[i] + t * path.points[i + 1],
            ((1 - t) * path.outward[i] + t * path.outward[i + 1]).stableNormalized()};
  }
  return {path.points.back(), path.outward.back()};
}

RayHit hit_third_solid(const GrownSolids& solids, Index solid_a, Index solid_b, const Vector3& from,
                       const Vector3& direction, double reach, double diagonal) {
  RayHit out;
  for (Index c = 0; c < solids.count(); ++c) {
    if (c == solid_a || c == solid_b) continue;
    double t = 0;
    for (int round = 0; round < ray_steps && t <= reach; ++round) {
      const double d = solids.distance(c, from + t * direction);
      if (d <= 1e-6 * diagonal) {
        if (out.solid == no_index || t < out.distance) out = {c, from + t * direction, t};
        break;
      }
      t += d;
    }
  }
  return out;
}

}  // namespace hariko
