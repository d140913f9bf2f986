#pragma once

// A skin as it is computed: near zero.

#include <vector>

#include "core/polyhedron/polyhedron.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

/// A skin whose positions are relative to an origin in its middle (`origin_for`): what is made from it is as
/// precise a million units away as at zero.
struct LocalSkin {
  Vector3 origin = Vector3::Zero();
  Skin skin;
};

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
