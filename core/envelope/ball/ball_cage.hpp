#pragma once

// BallCage: quad mesh on the zero surface of a field, whose quads become the patches, and the contour that it
// is made of (docs/envelope.md).

#include "core/envelope/ball/cube_tree.hpp"
#include "core/envelope/ball/hermite_patch.hpp"

namespace hariko {

/// Vertex of a contour, in one cube.
struct ContourVertex {
  Cube cube;
  Vector3 position = Vector3::Zero();  ///< mean of the points where the surface crosses the cube's edges
  /// Number of faces at the vertex; two where the surface crosses only one split edge of its cube.
  int faces = 0;
};

/// Closed manifold mesh made by dual marching cubes over cubes of several sizes.
struct Contour {
  std::vector<ContourVertex> vertices;
  /// Counter-clockwise seen from outside; triangles end with no_index.
  std::vector<std::array<Index, 4>> faces;
};

/// Makes the contour of a field that is negative inside, 1-Lipschitz, and positive on the boundary of the
/// box. Each edge of the result is used by two faces, each vertex by one fan. O(cubes of the box).
Contour contour(const CubeTree& cubes, const SplineField& field);

/// Quad mesh of a rolling-ball envelope.
struct BallCage {
  std::vector<Vector3> positions;           ///< vertices on the surface
  std::vector<std::array<Index, 4>> quads;  ///< counter-clockwise seen from outside; closed, manifold
  std::vector<Cube> cubes;                  ///< one per quad: splitting it makes the quads there smaller
};

/// Makes the quad mesh. Its sides are as long as the cubes' edges where all cubes have the same size, else
/// half as long: triangles between cubes of different sizes, and then all other faces too, are divided into
/// stars of quads. Cavities that cannot be reached from outside get no quads. Splits cubes where the mesh
/// needs it.
BallCage ball_cage(const SplineField& field, CubeTree& cubes);

/// Sides of faces, numbered in the order in which they come first.
struct FaceSides {
  std::vector<std::array<Index, 2>> ends;     ///< in ascending order
  std::vector<std::array<Index, 4>> of_face;  ///< from corner to corner
};
/// Finds the sides. Triangles end with no_index. O(faces) where few sides meet at a vertex.
FaceSides sides_of(std::span<const std::array<Index, 4>> faces, std::size_t vertices);

/// Cuts of a quad: across its sides 0 and 2, across its sides 1 and 3.
using QuadCuts = std::array<bool, 2>;

/// Cuts quads, each together with all quads that follow one another across opposite sides, so that no vertex
/// lies inside a side. `patches`, `cuts`: one per quad. `longest`: largest displacement of a new vertex, a
/// length.
BallCage cut_cage(const SplineField& field, const BallCage& cage, const HermitePatchSet& patches,
                  std::span<const QuadCuts> cuts, double longest);

/// Topology of a closed mesh: number of components, and number of tunnels (the total genus).
struct CageTopology {
  int components = 0, tunnels = 0;
};
/// Topology of a cage. O(quads).
CageTopology topology_of(const BallCage& cage);

}  // namespace hariko
