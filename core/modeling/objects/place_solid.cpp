#include "core/modeling/objects/place_solid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/document/angles.hpp"
#include "core/envelope/solid_shape.hpp"
#include "core/geometry/rotation.hpp"

namespace hariko {

namespace {

/// smallest step relative to the solid's size, so that rays along a side advance
constexpr double least_step = 1e-4;
constexpr double normal_step = 1e-6;  ///< relative to the solid's size
constexpr int bisections = 40;

/// Distance of the base below the solid's position, before scaling.
double height_below(const Solid& solid) {
  switch (solid.kind) {
    case SolidKind::box:
      return solid.size.z() / 2;
    case SolidKind::cylinder:
    case SolidKind::prism:
      return solid.height / 2;
    case SolidKind::cone:
    case SolidKind::pyramid:
      return solid.height / 4;
    case SolidKind::capsule:
      return solid.length / 2 + solid.radius;
    case SolidKind::torus:
      return solid.tube;
    case SolidKind::sphere:
      return solid.radius;
    case SolidKind::polyhedron:
      break;
  }
  double low = 0;
  for (const Vector3& p : solid.points) low = std::min(low, p.z());
  return -low;
}

}  // namespace

std::optional<SolidHit> hit_solids(std::span<const Solid> solids, const Vector3& origin,
                                   const Vector3& direction) {
  std::optional<SolidHit> nearest;
  for (const Solid& solid : solids) {
    const SolidShape shape(solid, Vector3::Zero());
    // The march runs from where the ray enters the sphere round the solid to where it leaves it.
    const double along = direction.dot(shape.centre() - origin);
    const double beside = (origin + along * direction - shape.centre()).norm();
    if (beside > shape.reach() || shape.distance(origin) <= 0) continue;
    const double half = std::sqrt(shape.reach() * shape.reach() - beside * beside);
    const double shortest = least_step * shape.reach();
    double t = std::max(0.0, along - half), before = t;
    while (t <= along + half) {
      const double d = shape.distance(origin + t * direction);
      if (d <= 0) break;
      before = t;
      t += std::max(d, shortest);
    }
    if (t > along + half || (nearest && before > nearest->distance)) continue;
    for (int round = 0; round < bisections; ++round) {
      const double middle = 0.5 * (before + t);
      (shape.distance(origin + middle * direction) > 0 ? before : t) = middle;
    }
    const Vector3 point = origin + before * direction;
    // On an edge the normal of either face may result; a little before it, it is that of a face the ray runs
    // to.
    const Vector3 in_front = origin + (before - normal_step * shape.reach()) * direction;
    nearest = SolidHit{solid.id, point, shape.place(in_front).gradient, before};
  }
  return nearest;
}

Solid standing_on(Solid solid, const Vector3& point, const Vector3& up) {
  solid.position = point + height_below(solid) * solid.scale.z() * up;
  solid.rotation =
      up.z() >= 1 - 1e-12 ? Vector3(Vector3::Zero()) : angles_of(least_rotation(Vector3::UnitZ(), up));
  return solid;
}

}  // namespace hariko
