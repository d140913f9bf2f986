#pragma once

// Solids put on the ground or on each other.

#include <optional>
#include <span>

#include "core/envelope/solid.hpp"

namespace hariko {

struct SolidHit {
  std::uint32_t solid = 0;  ///< its id
  Vector3 point = Vector3::Zero(), normal = Vector3::UnitZ();
  double distance = 0;  ///< along the ray
};

/// Where a ray (direction unit) first meets one of the solids from outside.
std::optional<SolidHit> hit_solids(std::span<const Solid> solids, const Vector3& origin,
                                   const Vector3& direction);

/// The solid with the middle of its base on a point and its axis along a unit direction. Straight up it is
/// not turned.
Solid standing_on(Solid solid, const Vector3& point, const Vector3& up);

}  // namespace hariko
