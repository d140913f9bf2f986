#pragma once

// Where a network's surface and its solids cut each other: the measure of the search for enclosure (spec 6).

#include "core/envelope/curve_network.hpp"

namespace hariko {

/// Surface in a solid, and solids out of the surface.
struct Violations {
  struct InSolid {
    Index face, solid;
    double depth;  ///< of the deepest sample of the face
    Vector3 point;
  };
  struct Outside {
    Index face, solid;
    Vector3 point;  ///< of the solid's test points near the face
    double height;  ///< least above the tangent planes at the four nearest samples
  };
  std::vector<InSolid> in_solid;  ///< at most one a face and solid, unless all were asked for
  std::vector<Outside> outside;   ///< the same
  double worst = 0;               ///< largest depth or height, also within the tolerance
};

/// Samples every patch at the nodes of the grid. Blocks of samples have balls round them, which leave out
/// nearly all comparisons; the result is that of comparing everything. Violations up to `tolerance` (a
/// length) are not listed. `which`: the worst of each face and solid, or all points outside and the deepest
/// sample of every block, so that a symmetric surface has symmetric violations.
enum class ListedViolations : std::uint8_t { worst, all };
Violations find_violations(const CurveNetwork& network, std::span<const PlacedSolid> solids, double tolerance,
                           const EnvelopeGrid& grid, ListedViolations which = ListedViolations::worst);

}  // namespace hariko
