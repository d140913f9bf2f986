#pragma once

// Pieces: rectangles, made by cutting and joining the patches of a surface, that become faces of a CAD model.

#include <array>
#include <optional>
#include <vector>

#include "core/cad/corner_warp.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Part of a patch's side, or of a curve inside a patch that two pieces share; for such a curve `side.patch`
/// is no_index and `inner` its number. begin < end means along it.
struct CellSide {
  PatchSide side;
  double begin = 0, end = 1;
  Index inner = no_index;
};

/// Image of the unit square in a patch's parameters, bilinear. With `chart`: in the parameters of a face of
/// mode G2. With `fan`: in the coordinates of a regular polygon of radius 1 round the split point of a face,
/// over these triangles.
struct CadCell {
  Index patch = no_index;
  bool chart = false;
  std::vector<Index> fan;
  std::array<Vector2, 4> corners;  ///< images of (0, 0), (1, 0), (1, 1), (0, 1)
  std::array<CellSide, 4> sides;   ///< counter-clockwise, as sides of squares
};

/// Grid of cells, row by row, between the breaks in s and t, which ascend from 0. Between its cells the
/// surface is as smooth as a spline of its degree with simple knots there.
struct CadPiece {
  std::vector<double> s{0, 1}, t{0, 1};
  std::vector<CadCell> cells;
  /// Knots of the curve along each side, both ends included: the breaks at which it is more than one
  /// polynomial. Empty: all breaks.
  std::array<std::vector<double>, 4> side_knots;
  /// Maps of the piece's parameters to those of its only cell, in the order in which they are applied; none
  /// where there are several cells.
  std::vector<CornerWarp> warps{};

  Index columns() const { return Index(s.size() - 1); }
  Index rows() const { return Index(t.size() - 1); }
  /// Number of cells along a side.
  Index cell_count(int side) const { return side % 2 == 0 ? columns() : rows(); }
  /// Length of a side in its own parameter, which begins at 0.
  double length(int side) const { return side % 2 == 0 ? s.back() : t.back(); }
  /// Breaks along a side, counter-clockwise.
  std::vector<double> breaks(int side) const;
  /// Knots that the side's curve needs.
  std::vector<double> knots(int side) const {
    return side_knots[std::size_t(side)].empty() ? breaks(side) : side_knots[std::size_t(side)];
  }
  /// Cell at place `at` along a side, counter-clockwise.
  const CadCell& cell(int side, Index at) const;
  /// (s, t) of the point at x in 0 .. length(side) along a side, counter-clockwise.
  Vector2 parameter(int side, double x) const;
};

/// Division of a surface into pieces.
enum class CadPieces {
  /// Squares of one spline joined to rectangles; triangles as three squares each, round their corners.
  patches,
  faces  ///< the same, but triangles round the split point of a face together
};

/// Pieces that cover a surface once, without degenerate sides. Faces of triangles round a split point, and
/// faces of mode G2, are one square where they have four sides, otherwise one square per corner. No piece
/// meets itself. `warped`: with `CadPiece::warps`. O(patches).
std::vector<CadPiece> cad_pieces(const Surface& surface, CadPieces which = CadPieces::faces,
                                 bool warped = true);

/// Patches of a surface of Bezier patches; none for other surfaces.
std::vector<BezierPatch> bezier_patches(const Surface& surface);
/// Degree of a spline that can hold all patches: their largest degree in s or t. Nothing where there are
/// none, one is rational, or the degree is too high.
std::optional<int> bezier_degree(const std::vector<BezierPatch>& patches);

/// Evaluates points of one piece, with derivatives by s and t. The surface and the piece must outlive it.
/// Thread-safe.
class PieceEvaluator {
 public:
  PieceEvaluator(const Surface& surface, const CadPiece& piece);
  /// Point at (s, t); where `order` is first, second derivatives are zero.
  PatchPoint at(double s, double t, Order order = Order::first) const;

 private:
  PatchPoint patch_point(Index patch, const Vector2& at, Order order) const;
  PatchPoint fan_point(const CadCell& cell, const Vector2& at, Order order) const;
  PatchPoint cell_point(double s, double t, Order order) const;
  PatchPoint warped_point(const Vector2& at, Order order) const;

  const PatchSet* patches_;
  const ChartEvaluation* charts_;  ///< null where the patches have none
  const CadPiece* piece_;
  std::vector<Vector2> polygon_;  ///< corners of the fan's polygon
};

/// Rectangles of square patches that are pieces of one spline (cad_pieces): bicubic ones, and Bezier patches
/// of the degree that `bezier_degree` gives, whose knots may be unevenly spaced.
std::vector<CadPiece> merged_squares(const Surface& surface);

}  // namespace hariko
