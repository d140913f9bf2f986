#pragma once

// Topology of a CAD model: edges and vertices of the pieces of a surface, before there are curves.

#include <array>
#include <vector>

#include "core/cad/cad_piece.hpp"

namespace hariko {

/// Part of a piece's side, in the side's direction (counter-clockwise) and parameter, begin < end.
struct CadUse {
  Index piece = no_index;
  int side = 0;
  double begin = 0, end = 1;
};

/// Edge along its first use and against its second; edges with one use are borders.
struct PlannedEdge {
  Index begin = no_index, end = no_index;  ///< vertices
  std::array<CadUse, 2> uses;
  int use_count = 1;
  bool smooth = true;  ///< the surface is meant to have a common tangent plane across it
};

/// Vertices and edges of a CAD model, without geometry.
struct CadPlan {
  Index vertex_count = 0;
  std::vector<PlannedEdge> edges;
  /// Edges of the four sides of each piece, in the sides' directions.
  std::vector<std::array<std::vector<Index>, 4>> sides;
};

/// Plans the edges and vertices of pieces. A side that meets several others is divided; a common boundary of
/// two pieces that runs along several patches is one edge. O(pieces log pieces).
CadPlan plan_cad(const Surface& surface, const std::vector<CadPiece>& pieces);

}  // namespace hariko
