#pragma once

// Pieces: how the patches of a surface are cut and joined into the rectangles that become faces of a CAD
// model.

#include <array>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko {

/// Part of a patch's side, or a curve inside of a patch that pieces have in common: then `side.patch` is
/// no_index and `inner` is the curve's number; begin < end means along it.
struct CellSide {
  PatchSide side;
  double begin = 0, end = 1;
  Index inner = no_index;
};

/// The unit square as a bilinear image in a patch's parameters; `chart`: in those of a face of mode G2.
struct CadCell {
  Index patch = no_index;
  bool chart = false;
  std::array<Vector2, 4> corners;  ///< of (0, 0), (1, 0), (1, 1), (0, 1)
  std::array<CellSide, 4> sides;   ///< counter-clockwise, as sides of squares
};

/// columns x rows cells, row by row, over 0 <= s <= columns, 0 <= t <= rows. Between its cells the surface
/// has two continuous derivatives by s and t.
struct CadPiece {
  Index columns = 1, rows = 1;
  std::vector<CadCell> cells;

  Index length(int side) const { return side % 2 == 0 ? columns : rows; }
  /// The cell at place `at` along a side, counter-clockwise.
  const CadCell& cell(int side, Index at) const;
  /// (s, t) of the point at x in 0 .. length(side) along a side, counter-clockwise.
  Vector2 parameter(int side, double x) const;
};

/// Pieces that cover a surface once. Squares become faces as they are, or rectangles of faces where they are
/// pieces of one bicubic spline; triangles three squares each, round their corners, which have no degenerate
/// sides; faces of mode G2 as many squares as they have corners. No piece meets itself. O(patches).
std::vector<CadPiece> cad_pieces(const Surface& surface);

/// Point of a piece with derivatives by s and t.
PatchPoint evaluate(const Surface& surface, const CadPiece& piece, double s, double t);

/// Of squares: rectangles of patches that are pieces of one bicubic spline (cad_pieces).
std::vector<CadPiece> merged_squares(const Surface& surface);

}  // namespace hariko
