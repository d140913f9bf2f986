#pragma once

// Grids of bicubic Bezier patches: the control net as a value, the patches as a PatchSet, and as a Surface.

#include <array>
#include <memory>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko {

/// Control net of a grid of bicubic patches: columns x rows patches over (3 columns + 1) x (3 rows + 1)
/// control points, row by row: point (i, j) is points[j (3 columns + 1) + i]. Patch (k, l), number l columns
/// + k, has the points 3k .. 3k + 3 by 3l .. 3l + 3; its s runs with i and its t with j. Neighbours share a
/// row or column of points.
struct BicubicNet {
  Index columns = 0, rows = 0;
  std::vector<Vector3> points;

  Index width() const { return 3 * columns + 1; }
  Index height() const { return 3 * rows + 1; }
  Index patch_count() const { return columns * rows; }
  Index index(Index i, Index j) const { return j * width() + i; }
  const Vector3& at(Index i, Index j) const { return points[index(i, j)]; }
  /// Index of point (i, j), 0 .. 3, of a patch.
  Index index(Index patch, int i, int j) const {
    return index(3 * (patch % columns) + Index(i), 3 * (patch / columns) + Index(j));
  }
  friend bool operator==(const BicubicNet&, const BicubicNet&) = default;
};

/// Outer side of one patch of a net: side 0 .. 3 of the grid, numbered as in a patch, and the place of the
/// patch along it, counted in the side's own direction (counter-clockwise).
struct NetSide {
  std::uint8_t side = 0;
  Index place = 0;
  friend auto operator<=>(const NetSide&, const NetSide&) = default;
};
/// Number of patches along a side of the grid.
inline Index places_of(const BicubicNet& net, int side) {
  return side % 2 == 0 ? net.columns : net.rows;
}
/// Patch that an outer side belongs to.
Index patch_of(const BicubicNet& net, NetSide side);
/// Indices of the four control points of an outer side in its direction, and of the row behind them (P(i,0)
/// and P(i,1)).
struct SideRows {
  std::array<Index, 4> curve, row;
};
/// Control points of an outer side and the row behind it.
SideRows side_rows(const BicubicNet& net, NetSide side);

/// Patches of a bicubic net.
class BicubicPatchSet final : public PatchSet {
 public:
  /// Takes a net whose number of points fits its size (asserted).
  explicit BicubicPatchSet(BicubicNet net);

  const BicubicNet& net() const { return net_; }

  Domain domain() const override { return Domain::square; }
  Index patch_count() const override { return net_.patch_count(); }
  PatchPoint evaluate(Index patch, const Vector2& parameter, Order order) const override;
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern, std::span<Vector3> positions,
                     std::span<Vector3> normals) const override;
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                     std::span<PatchPoint> points) const override;

  void positions(Index patch, std::span<const Vector2> parameters, std::span<Vector3> out) const override;
  void first_order(Index patch, std::span<const Vector2> parameters,
                   std::span<PatchPoint> out) const override;
  int hull_degree(Index) const override { return 6; }
  void hull(Index patch, const ParameterTriangle& triangle, std::span<const Vector3> samples,
            std::span<HullBall> out) const override;
  ExactForm exact_form(Index patch) const override { return BicubicPatch{controls(patch)}; }

 private:
  using Controls = std::array<Vector3, 16>;
  Controls controls(Index patch) const;
  BicubicNet net_;
};

/// Surface of a grid of bicubic patches. Seams between neighbours are G1 where both tangent planes agree to
/// 1e-6 rad all along, otherwise G0. A grid whose first and last column (row) of points are equal, bit for
/// bit, closes. Sources number the net's quads and points: a patch comes from the quad in its middle, a side
/// from the middle one of its three edges. O(patches).
Surface bicubic_surface(const Vector3& origin, BicubicNet net);

}  // namespace hariko
