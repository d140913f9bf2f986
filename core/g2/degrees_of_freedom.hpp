#pragma once

// G2Unknowns: the unknown vectors of mode G2 (derivatives of sectors, freedoms of edges), and the controls of
// corners and sides as functions of them (g2.md section 2).

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/network/vertex_frames.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Unknowns of a corner: (g11, g12, g22) = turn * (x[unknown[0]], x[unknown[1]], x[unknown[2]]).
struct CornerUnknowns {
  std::array<Index, 3> unknown{no_index, no_index, no_index};
  Matrix3 turn = Matrix3::Identity();
  /// First derivatives: (g1, g2) = tangent_turn * (x[tangent[0]], x[tangent[1]]).
  std::array<Index, 2> tangent{no_index, no_index};
  Eigen::Matrix2d tangent_turn = Eigen::Matrix2d::Identity();
  double opening = 0;  ///< opening of the sector
  /// At corner vertices: the unknowns are H(a, a), H(a, b), H(b, b) of the sharp edges a and b that bound the
  /// sector.
  bool between_sharp_edges = false;
};

/// Unknowns of a half-edge's side: control i of five is sign[i] * x[unknown[i]].
struct SideUnknowns {
  std::array<Index, 5> unknown;
  std::array<double, 5> sign;
};

/// Unknowns of all vertices and edges. A closed sector has five vectors (its derivative and its quadratic
/// form); at a smooth sharp line the derivative and the form along the line are common to all sectors; at a
/// corner vertex each sharp edge has one of each, common to its sectors, and each sector one more of the
/// form. An edge has one vector of its curve, shared even by the two sides of a crease, and four of its cross
/// derivatives, which a crease has on each side.
struct G2Unknowns {
  Index count = 0;
  std::vector<CornerUnknowns> corner;  ///< per half-edge: the corner at its origin
  std::vector<SideUnknowns> side;      ///< per half-edge
};

/// Numbers the unknowns of a mesh.
G2Unknowns g2_unknowns(const HalfEdgeMesh& mesh, const VertexFrames& frames);

}  // namespace hariko
