#pragma once

// Which edges and vertices the pieces of a surface have, before there are curves: connectivity alone.

#include <array>
#include <vector>

#include "core/cad/cad_piece.hpp"

namespace hariko {

/// A stretch of a piece's side, in the side's direction (counter-clockwise) and parameter, begin < end.
struct CadUse {
  Index piece = no_index;
  int side = 0;
  double begin = 0, end = 1;
};

/// Runs along its first use and against its second; edges with one use are borders.
struct PlannedEdge {
  Index begin = no_index, end = no_index;  ///< vertices
  std::array<CadUse, 2> uses;
  int use_count = 1;
  bool smooth = true;  ///< the surface is meant to have one tangent plane across it
};

struct CadPlan {
  Index vertex_count = 0;
  std::vector<PlannedEdge> edges;
  /// Of each piece: the edges of its four sides, in the sides' directions.
  std::vector<std::array<std::vector<Index>, 4>> sides;
};

/// Where one side meets several, it is divided; where two pieces meet along several patches in a row, that is
/// one edge. O(pieces log pieces).
CadPlan plan_cad(const Surface& surface, const std::vector<CadPiece>& pieces);

}  // namespace hariko
