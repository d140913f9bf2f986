#pragma once

// Test that every solid lies inside the surface. Independent of the construction of the surface: dense points
// of the solids against winding numbers of the surface's triangles.

#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/envelope/solid_shape.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Sampling density of the test.
struct EnclosureEffort {
  int density = 16;     ///< intervals per patch side of the triangulation
  int points = 500;     ///< points on the surface of each solid
  double spacing = 0;   ///< > 0, length; spacing of points on sharp curves, where these are near the surface
  bool covered = true;  ///< also look for patches inside other parts of the surface
};

/// Point of a solid outside the surface.
struct OutsidePoint {
  Vector3 point;
  Index solid;
  Index patch;      ///< nearest patch of the surface
  double distance;  ///< distance from the surface
};

struct EnclosureReport {
  std::size_t tested = 0, outside = 0;
  double worst = 0;  ///< largest distance of a point outside from the surface, length
  std::vector<OutsidePoint> points;
  std::size_t covered = 0;  ///< number of patches that lie partly inside another part of the surface
};

/// Tests surface points of the solids and points of their sharp curves, except those inside other solids, and
/// whether points of the surface lie inside a solid. Points within `slack` (a length) of the surface count as
/// inside. Shapes are relative to the surface's origin. O((points + patches * density^2) log(patches *
/// density^2)).
EnclosureReport check_enclosure(const Surface& surface, std::span<const SolidShape> solids,
                                const EnclosureEffort& effort, double slack, const CancelToken& cancel = {});

}  // namespace hariko
