#pragma once

// Is every solid inside the surface? Independent of how the surface was made: dense points of the solids
// against winding numbers of the surface's triangles.

#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/envelope/placed_solid.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

struct OutsidePoint {
  Vector3 point;
  Index solid;      ///< placed solid
  Index patch;      ///< of the surface, the nearest one
  double distance;  ///< from the surface
};

struct EnclosureReport {
  std::size_t tested = 0, outside = 0;
  double worst = 0;  ///< distance of the farthest point outside from the surface, length
  std::vector<OutsidePoint> points;
};

/// `density`: intervals a patch side of the triangles. `points`: spread over each solid, beside its test
/// points and a twentieth of `points` on every edge. Points within `slack` (a length) of the surface count as
/// inside.
EnclosureReport check_enclosure(const Surface& surface, std::span<const PlacedSolid> solids, int density,
                                int points, double slack, const CancelToken& cancel = {});

}  // namespace hariko
