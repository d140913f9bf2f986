#pragma once

// G2Unknowns: the unknown vectors of mode G2 (second derivatives of sectors, freedoms of edges), and how the
// controls of corners and sides depend on them (g2.md section 2).

#include <array>
#include <vector>

#include "core/network/vertex_frames.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// (g11, g12, g22) of a corner = turn * (x[unknown[0]], x[unknown[1]], x[unknown[2]]).
struct CornerUnknowns {
  std::array<Index, 3> unknown{no_index, no_index, no_index};
  Matrix3 turn = Matrix3::Identity();
  /// Straight corners only: g2 = tangent_sign * x[tangent]. Elsewhere the network gives g2.
  Index tangent = no_index;
  double tangent_sign = 1;
  /// Corner vertices: the unknowns are H(a, a), H(a, b), H(b, b) of the sharp edges a and b that bound the
  /// sector.
  bool between_sharp_edges = false;
  Index sector_size = 0;  ///< corners of the sector
};

/// The five controls of a half-edge's side: control i = sign[i] * x[unknown[i]].
struct SideUnknowns {
  std::array<Index, 5> unknown;
  std::array<double, 5> sign;
};

/// Depends on connectivity and tags only. Per closed sector three vectors (its quadratic form); at a smooth
/// sharp line the form along the line is common to all sectors; at a corner vertex each sharp edge has one
/// vector, common to its sectors, and each sector one more. Per edge one vector of its curve, shared even by
/// a crease's sides, and four of its cross derivatives, which a crease has on each side.
struct G2Unknowns {
  Index count = 0;
  std::vector<CornerUnknowns> corner;  ///< per half-edge: the corner at its origin
  std::vector<SideUnknowns> side;      ///< per half-edge
};

G2Unknowns g2_unknowns(const HalfEdgeMesh& mesh, const VertexFrames& frames);

}  // namespace hariko
