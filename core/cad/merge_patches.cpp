// Rectangles of square patches that are pieces of one bicubic spline.

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/cad/cad_piece.hpp"
#include "core/skinning/subdivision_surface.hpp"
#include "core/surface/bicubic_patch.hpp"

namespace hariko {

namespace {

/// Larger rectangles make systems that take long, and files that others are slow to read.
constexpr Index longest_side = 128;
/// Two derivatives that agree to this, of the patch's size, are one spline's.
constexpr double same = 1e-10;

/// A patch, turned so that its side `turn` is the cell's side 0.
struct Placed {
  Index patch = no_index;
  int turn = 0;
};

/// Value and derivatives by x along a side and y into the patch.
struct SideJet {
  Vector3 position, x, y, xx, xy, yy;
};
SideJet side_jet(const Surface& surface, PatchSide side, double at) {
  const PatchPoint p =
      surface.patches().evaluate(side.patch, side_parameter(Domain::square, side.side, at), Order::second);
  switch (side.side) {
    case 0:
      return {p.position, p.ds, p.dt, p.dss, p.dst, p.dtt};
    case 1:
      return {p.position, p.dt, -p.ds, p.dtt, -p.dst, p.dss};
    case 2:
      return {p.position, -p.ds, -p.dt, p.dss, p.dst, p.dtt};
    default:
      return {p.position, -p.dt, p.ds, p.dtt, -p.dst, p.dss};
  }
}

class Merger {
 public:
  explicit Merger(const Surface& surface)
      : surface_(surface), across_(4 * surface.patch_count()), neighbours_(4 * surface.patch_count()) {
    for (const Seam& seam : surface.seams()) {
      neighbours_[slot(seam.first)].push_back(seam.second.patch);
      neighbours_[slot(seam.second)].push_back(seam.first.patch);
      if (seam.first.patch == seam.second.patch) {
        meets_itself_.push_back(seam.first.patch);
        continue;
      }
      const bool whole =
          seam.first_begin == 0 && seam.first_end == 1 && seam.second_begin == 1 && seam.second_end == 0;
      if (!whole || !spline(seam.first.patch) || !spline(seam.second.patch) || !smooth(seam)) continue;
      across_[slot(seam.first)] = seam.second;
      across_[slot(seam.second)] = seam.first;
    }
    taken_.assign(surface.patch_count(), 0);
  }

  std::vector<CadPiece> run() {
    std::vector<CadPiece> out;
    for (const Index patch : meets_itself_) {
      if (taken_[patch]) continue;
      taken_[patch] = 1;
      add_quarters(patch, out);
    }
    for (Index patch = 0; patch < surface_.patch_count(); ++patch) {
      if (taken_[patch]) continue;
      const Rectangle wide = open(grow({patch, 0})), tall = open(grow({patch, 1}));
      add(wide.placed.size() >= tall.placed.size() ? wide : tall, out);
    }
    return out;
  }

 private:
  struct Rectangle {
    Index columns = 0, rows = 0;
    std::vector<Placed> placed;

    /// The part of the first columns and rows.
    Rectangle part(Index width, Index height) const {
      Rectangle out{width, height, {}};
      for (Index row = 0; row < height; ++row)
        out.placed.insert(out.placed.end(), placed.begin() + row * columns,
                          placed.begin() + row * columns + width);
      return out;
    }
  };

  static std::size_t slot(PatchSide side) { return 4 * std::size_t(side.patch) + side.side; }

  /// The patch is one bicubic polynomial.
  bool spline(Index patch) const {
    if (const SubdivisionPatchSet* set = subdivision_patches(surface_))
      return set->topology().polynomial(patch);
    return dynamic_cast<const BicubicPatchSet*>(&surface_.patches()) != nullptr;
  }

  /// Both sides have the same derivatives up to the second: four places decide for cubics.
  bool smooth(const Seam& seam) const {
    if (seam.intended == Continuity::g0) return false;
    const double size =
        std::max(surface_.patch_scale(seam.first.patch), surface_.patch_scale(seam.second.patch));
    const auto equal = [&](const Vector3& a, const Vector3& b) {
      return (a - b).lpNorm<Eigen::Infinity>() <= same * size;
    };
    for (const double x : {0.0, 1.0 / 3, 2.0 / 3, 1.0}) {
      const SideJet a = side_jet(surface_, seam.first, x), b = side_jet(surface_, seam.second, 1 - x);
      if (!equal(a.x, -b.x) || !equal(a.y, -b.y) || !equal(a.xx, b.xx) || !equal(a.xy, b.xy) ||
          !equal(a.yy, b.yy))
        return false;
    }
    return true;
  }

  /// What lies beyond side `side` of a cell, turned the same way.
  std::optional<Placed> beyond(const Placed& at, int side) const {
    const PatchSide other = across_[slot({at.patch, std::uint8_t((at.turn + side) % 4)})];
    if (other.patch == no_index || taken_[other.patch]) return {};
    // The neighbour's side that meets ours is its cell's side opposite to it.
    return Placed{other.patch, (other.side + 4 - (side + 2) % 4) % 4};
  }

  static bool contains(const std::vector<Placed>& list, Index patch) {
    return std::any_of(list.begin(), list.end(), [&](const Placed& p) { return p.patch == patch; });
  }

  /// As long a row as there is through a cell, then as many rows as there are.
  Rectangle grow(const Placed& start) {
    std::vector<Placed> row{start};
    for (const int side : {1, 3}) {
      while (row.size() < longest_side) {
        const auto next = beyond(side == 1 ? row.back() : row.front(), side);
        if (!next || contains(row, next->patch)) break;
        row.insert(side == 1 ? row.end() : row.begin(), *next);
      }
    }
    Rectangle out{Index(row.size()), 1, row};
    std::set<Index> inside;
    for (const Placed& p : row) inside.insert(p.patch);
    for (const int side : {2, 0}) {
      while (out.rows < longest_side) {
        const std::vector<Placed> next = next_row(out, side, inside);
        if (next.empty()) break;
        for (const Placed& p : next) inside.insert(p.patch);
        out.placed.insert(side == 2 ? out.placed.end() : out.placed.begin(), next.begin(), next.end());
        ++out.rows;
      }
    }
    return out;
  }

  /// The row of cells beyond the first or last row; empty where there is none.
  std::vector<Placed> next_row(const Rectangle& rectangle, int side, const std::set<Index>& inside) const {
    std::vector<Placed> next;
    const std::size_t edge = side == 2 ? rectangle.placed.size() - rectangle.columns : 0;
    for (std::size_t i = 0; i < rectangle.columns; ++i) {
      const auto found = beyond(rectangle.placed[edge + i], side);
      if (!found || inside.contains(found->patch) || contains(next, found->patch)) return {};
      if (i > 0) {  // the row runs on
        const auto along = beyond(next.back(), 1);
        if (!along || along->patch != found->patch || along->turn != found->turn) return {};
      }
      next.push_back(*found);
    }
    return next;
  }

  /// Halved until it does not meet itself: what closes to a ring becomes two pieces.
  Rectangle open(Rectangle rectangle) const {
    for (;;) {
      const auto meeting = meeting_sides(rectangle);
      if (!meeting) return rectangle;
      const auto [a, b] = *meeting;
      const bool by_columns = a % 2 == 1 && b % 2 == 1   ? rectangle.columns > 1
                              : a % 2 == 0 && b % 2 == 0 ? rectangle.rows == 1
                                                         : rectangle.columns >= rectangle.rows;
      rectangle = by_columns ? rectangle.part((rectangle.columns + 1) / 2, rectangle.rows)
                             : rectangle.part(rectangle.columns, (rectangle.rows + 1) / 2);
    }
  }

  /// Two sides of the rectangle that have a seam in common.
  std::optional<std::pair<int, int>> meeting_sides(const Rectangle& rectangle) const {
    if (rectangle.placed.size() == 1) return {};  // patches that meet themselves are cut before
    std::map<Index, std::set<int>> border;        // the rectangle's sides at each patch
    const auto each = [&](const auto& visit) {
      for (Index i = 0; i < rectangle.columns; ++i)
        visit(rectangle.placed[i], 0),
            visit(rectangle.placed[(rectangle.rows - 1) * rectangle.columns + i], 2);
      for (Index j = 0; j < rectangle.rows; ++j)
        visit(rectangle.placed[j * rectangle.columns + rectangle.columns - 1], 1),
            visit(rectangle.placed[j * rectangle.columns], 3);
    };
    each([&](const Placed& p, int side) { border[p.patch].insert(side); });
    std::optional<std::pair<int, int>> out;
    each([&](const Placed& p, int side) {
      for (const Index other : neighbours_[slot({p.patch, std::uint8_t((p.turn + side) % 4)})])
        if (const auto found = border.find(other); !out && found != border.end() && other != p.patch)
          out = std::pair{side,
                          found->second.contains((side + 2) % 4) ? (side + 2) % 4 : *found->second.begin()};
    });
    return out;
  }

  void add(const Rectangle& rectangle, std::vector<CadPiece>& out) {
    CadPiece piece{rectangle.columns, rectangle.rows, {}};
    for (const Placed& placed : rectangle.placed) {
      taken_[placed.patch] = 1;
      CadCell cell;
      cell.patch = placed.patch;
      for (int k = 0; k < 4; ++k) {
        const int own = (placed.turn + k) % 4;
        cell.corners[std::size_t(k)] = corner_parameter(Domain::square, own);
        cell.sides[std::size_t(k)] = {{placed.patch, std::uint8_t(own)}, 0, 1, no_index};
      }
      piece.cells.push_back(cell);
    }
    out.push_back(std::move(piece));
  }

  /// A patch that closes with itself, as four pieces.
  void add_quarters(Index patch, std::vector<CadPiece>& out) {
    const Vector2 centre(0.5, 0.5);
    for (int k = 0; k < 4; ++k) {
      const int before = (k + 3) % 4;
      const Index first = 4 * patch;
      CadCell cell;
      cell.patch = patch;
      cell.corners = {corner_parameter(Domain::square, k), side_parameter(Domain::square, k, 0.5), centre,
                      side_parameter(Domain::square, before, 0.5)};
      cell.sides = {CellSide{{patch, std::uint8_t(k)}, 0, 0.5, no_index},
                    CellSide{{}, 0, 1, first + Index(k)}, CellSide{{}, 1, 0, first + Index(before)},
                    CellSide{{patch, std::uint8_t(before)}, 0.5, 1, no_index}};
      out.push_back({1, 1, {cell}});
    }
  }

  const Surface& surface_;
  std::vector<PatchSide> across_;               ///< the side beyond each side, where both are one spline
  std::vector<std::vector<Index>> neighbours_;  ///< patches beyond each side
  std::vector<Index> meets_itself_;
  std::vector<char> taken_;
};

}  // namespace

std::vector<CadPiece> merged_squares(const Surface& surface) {
  return Merger(surface).run();
}

}  // namespace hariko
