#pragma once

// LocalSkin: a skin relative to a nearby origin, for numerically precise evaluation.

#include <vector>

#include "core/polyhedron/polyhedron.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

/// Skin whose positions are relative to an origin near its centre (`origin_for`): results are as precise a
/// million units away as at the origin.
struct LocalSkin {
  Vector3 origin = Vector3::Zero();
  Skin skin;
};

/// Moves a skin to a nearby origin. O(points).
inline LocalSkin local_skin(const Skin& skin) {
  LocalSkin out{Vector3::Zero(), skin};
  std::vector<Vector3> positions;
  change_positions(out.skin, [&](const Vector3& position) { positions.push_back(position); });
  out.origin = origin_for(positions);
  change_positions(out.skin, [&](Vector3& position) { position -= out.origin; });
  if (out.skin.mirror) out.skin.mirror->position -= out.origin[out.skin.mirror->axis];
  return out;
}

}  // namespace hariko
