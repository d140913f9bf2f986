#pragma once

// Conversion of a skin into a polyhedron through points of its surface.

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

/// Converts a skin: vertices are the limit points of the control mesh, faces its faces. Tangent planes are
/// pinned where the skin has one, infinitely sharp edges become creases, and corners are tagged. Semi-sharp
/// creases are left out, because polyhedra have none. Errors: those of `SkinSurfacer::surface`, E_CANCELLED.
Result<SkinPolyhedron> skin_polyhedron(const Skin& skin, const CancelToken& cancel = {},
                                       const Progress& progress = {});

}  // namespace hariko
