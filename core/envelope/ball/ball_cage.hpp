#pragma once

// BallCage: quad mesh on the zero surface of a field, whose quads become the patches (docs/envelope.md).

#include <array>
#include <span>
#include <vector>

#include "core/envelope/ball/cube_tree.hpp"
#include "core/envelope/ball/hermite_patch.hpp"
#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

/// Quad mesh of a rolling-ball envelope.
struct BallCage {
  std::vector<Vector3> positions;           ///< vertices on the surface
  std::vector<std::array<Index, 4>> quads;  ///< counter-clockwise seen from outside; closed, manifold
  std::vector<Cube> cubes;                  ///< one per quad: splitting it makes the quads there smaller
};

/// Cubes that cover the surface, with corners at multiples of `edge` from the object's origin, split where
/// normals in a cube spread too widely for the mesh to represent the surface. `ahead`: cubes of the first
/// level are also split where they would be if they were half as large, as their points lie too far apart to
/// see the smallest parts. Positions are relative to `origin`. O(cubes of the box).
CubeTree surface_cubes(const SplineField& field, const Vector3& origin, double edge, bool ahead = false);

/// Makes the quad mesh. Its sides are as long as the cubes' edges where all cubes have the same size, else
/// half as long: triangles between cubes of different sizes, and then all other faces too, are divided into
/// stars of quads. Cavities that cannot be reached from outside get no quads. Splits cubes where the mesh
/// needs it.
BallCage ball_cage(const SplineField& field, CubeTree& cubes);

/// Cuts of a quad: across its sides 0 and 2, across its sides 1 and 3.
using QuadCuts = std::array<bool, 2>;

/// Cuts quads, each together with all quads that follow one another across opposite sides, so that no vertex
/// lies inside a side. `patches`, `cuts`: one per quad. `longest`: largest displacement of a new vertex, a
/// length.
BallCage cut_cage(const SplineField& field, const BallCage& cage, std::span<const HermitePatch> patches,
                  std::span<const QuadCuts> cuts, double longest);

/// Topology of a closed mesh: number of components, and number of tunnels (the total genus).
struct CageTopology {
  int components = 0, tunnels = 0;
};
/// Topology of a cage. O(quads).
CageTopology topology_of(const BallCage& cage);

}  // namespace hariko
