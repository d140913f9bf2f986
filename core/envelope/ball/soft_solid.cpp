#include "core/envelope/ball/soft_solid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/envelope/solid_shape.hpp"

namespace hariko {

namespace {

/// Largest inward move of faces relative to the inscribed ball's radius, so that part of every solid remains.
constexpr double most_softened = 0.95;

/// Distance of a cross-section's sides from the axis, in the narrower direction.
double narrowest(const Solid& s) {
  const bool round = s.kind == SolidKind::cylinder || s.kind == SolidKind::cone;
  return s.radius * (round ? 1 : std::cos(std::numbers::pi / s.sides)) * std::min(s.scale.x(), s.scale.y());
}

/// Scales a solid by `share` about a point in its own axes.
void shrink(Solid& solid, const Vector3& about, double share) {
  solid.position += solid_rotation(solid.rotation) * (1 - share) * about.cwiseProduct(solid.scale);
  solid.radius *= share;
  solid.height *= share;
  for (Vector3& p : solid.points) p *= share;
}

}  // namespace

Solid softened(const Solid& solid) {
  Solid out = solid;
  if (!solid.roundness) return out;
  const double part = most_softened * *solid.roundness;
  switch (solid.kind) {
    case SolidKind::sphere:
    case SolidKind::capsule:
    case SolidKind::torus:
      break;
    case SolidKind::box: {
      const Vector3 size = solid.size.cwiseProduct(solid.scale);
      out.size -= part * size.minCoeff() * solid.scale.cwiseInverse();
      break;
    }
    case SolidKind::cylinder:
    case SolidKind::prism: {
      const double beside = narrowest(solid), above = 0.5 * solid.height * solid.scale.z();
      const double inwards = part * std::min(beside, above);
      out.radius *= 1 - inwards / beside;
      out.height *= 1 - inwards / above;
      break;
    }
    case SolidKind::cone:
    case SolidKind::pyramid: {
      // The ball that touches the base and the sides stays where it is.
      const double beside = narrowest(solid), height = solid.height * solid.scale.z();
      const double held = beside * height / (beside + std::hypot(beside, height));
      shrink(out, {0, 0, held / solid.scale.z() - 0.25 * solid.height}, 1 - part);
      break;
    }
    case SolidKind::polyhedron: {
      Vector3 middle = Vector3::Zero();
      for (const Vector3& p : solid.points) middle += p / double(solid.points.size());
      shrink(out, middle, 1 - part);
      break;
    }
  }
  return out;
}

}  // namespace hariko
