#pragma once

// A skin becomes a polyhedron through the points of its surface, to go on with as with any other.

#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/source.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

struct SkinPolyhedron {
  PolyhedronSource source;
  /// Largest distance found from the polyhedron's surface to the skin, at 15 points of each of its patches; 0
  /// where that surface could not be made.
  double distance = 0;
  std::vector<Message> warnings;
};

/// Vertices are the limit points of the control mesh, faces its faces. Tangent planes are pinned where the
/// skin has one, edges that are sharp for ever are creases, and corners are tagged. Creases that fade are
/// left out, as the polyhedron has none such. Errors: those of `SkinSurfacer::surface`, E_CANCELLED.
Result<SkinPolyhedron> skin_polyhedron(const Skin& skin, const CancelToken& cancel = {},
                                       const Progress& progress = {});

}  // namespace hariko
