#pragma once

// Is every solid inside the surface? Independent of how the surface was made: dense points of the solids
// against winding numbers of the surface's triangles.

#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/envelope/solid_shape.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// How closely to look.
struct EnclosureEffort {
  int density = 16;     ///< intervals a patch side of the triangles
  int points = 500;     ///< spread over each solid
  double spacing = 0;   ///< > 0, length; of points on sharp curves, where these come near the surface
  bool covered = true;  ///< look for patches inside of other parts of the surface
};

struct OutsidePoint {
  Vector3 point;
  Index solid;
  Index patch;      ///< of the surface, the nearest one
  double distance;  ///< from the surface
};

struct EnclosureReport {
  std::size_t tested = 0, outside = 0;
  double worst = 0;  ///< distance of the farthest point outside from the surface, length
  std::vector<OutsidePoint> points;
  std::size_t covered = 0;  ///< patches of which some lies inside of another part of the surface
};

/// Tests points that are spread over the solids and points of their sharp curves, those inside of other
/// solids left out, and whether points of the surface lie inside of a solid. Points within `slack` (a length)
/// of the surface count as inside. Shapes are relative to the surface's origin. O((points + patches *
/// density^2) log(patches * density^2)).
EnclosureReport check_enclosure(const Surface& surface, std::span<const SolidShape> solids,
                                const EnclosureEffort& effort, double slack, const CancelToken& cancel = {});

}  // namespace hariko
