#pragma once

// Placing solids on the ground or on each other.

#include <optional>
#include <span>

#include "core/envelope/solid.hpp"

namespace hariko {

/// Hit of a ray on a solid.
struct SolidHit {
  std::uint32_t solid = 0;  ///< id of the solid
  Vector3 point = Vector3::Zero(), normal = Vector3::UnitZ();
  double distance = 0;  ///< along the ray
};

/// Returns the first point where a ray (unit direction) meets one of the solids from outside; nothing if
/// there is none.
std::optional<SolidHit> hit_solids(std::span<const Solid> solids, const Vector3& origin,
                                   const Vector3& direction);

/// Returns the solid with the centre of its base at a point and its axis along a unit direction. An axis
/// straight up leaves it unrotated.
Solid standing_on(Solid solid, const Vector3& point, const Vector3& up);

}  // namespace hariko
