#pragma once

// Quads on the surface where a field is zero: corners of the patches (docs/envelope.md).

#include <array>
#include <span>
#include <vector>

#include "core/envelope/ball/hermite_patch.hpp"
#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

struct BallCage {
  std::vector<Vector3> positions;           ///< on the surface
  std::vector<std::array<Index, 4>> quads;  ///< counter-clockwise seen from outside; closed, manifold
  double cell = 1;                          ///< about the length of their sides where none was split
};

/// Contours the field with cells of this size that lie at multiples of it from the object's zero; positions
/// are relative to `origin`. Hollows that cannot be reached from outside are filled. O(cells of the box).
BallCage ball_cage(const SplineField& field, const Vector3& origin, double cell);

/// Ways in which a quad is halved: across its sides 0 and 2, across its sides 1 and 3.
using QuadCuts = std::array<bool, 2>;

/// Halves quads, and with each all that follow one another across opposite sides, so that no vertex comes to
/// lie on a side. `patches`, `cuts`: one a quad.
BallCage cut_cage(const SplineField& field, const BallCage& cage, std::span<const HermitePatch> patches,
                  std::span<const QuadCuts> cuts);

/// Number of tunnels and of separate parts.
struct CageTopology {
  int components = 0, tunnels = 0;
};
CageTopology topology_of(const BallCage& cage);

}  // namespace hariko
