#pragma once

// Quads on the surface where a field is zero: corners of the patches (docs/envelope.md).

#include <array>
#include <span>
#include <vector>

#include "core/envelope/ball/cube_tree.hpp"
#include "core/envelope/ball/hermite_patch.hpp"
#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

struct BallCage {
  std::vector<Vector3> positions;           ///< on the surface
  std::vector<std::array<Index, 4>> quads;  ///< counter-clockwise seen from outside; closed, manifold
  std::vector<Cube> cubes;                  ///< one a quad: with its halves the quads about there are smaller
};

/// Cubes about the surface, with corners at multiples of `edge` from the object's zero, halved where one
/// would not show what the surface does: where normals in a cube spread too widely. Positions are relative to
/// `origin`. O(cubes of the box).
CubeTree surface_cubes(const SplineField& field, const Vector3& origin, double edge);

/// Quads with sides as long as the cubes' edges where these are all of one size, else half as long: triangles
/// between cubes of different sizes become stars of quads, and all other faces with them. Hollows that cannot
/// be reached from outside have none. Cubes are halved where edges of theirs have to be.
BallCage ball_cage(const SplineField& field, CubeTree& cubes);

/// Ways in which a quad is halved: across its sides 0 and 2, across its sides 1 and 3.
using QuadCuts = std::array<bool, 2>;

/// Halves quads, and with each all that follow one another across opposite sides, so that no vertex comes to
/// lie on a side. `patches`, `cuts`: one a quad. `longest`: no new vertex is moved farther, a length.
BallCage cut_cage(const SplineField& field, const BallCage& cage, std::span<const HermitePatch> patches,
                  std::span<const QuadCuts> cuts, double longest);

/// Number of tunnels and of separate parts.
struct CageTopology {
  int components = 0, tunnels = 0;
};
CageTopology topology_of(const BallCage& cage);

}  // namespace hariko
