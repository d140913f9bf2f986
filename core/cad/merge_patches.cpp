// Merging of square patches that are pieces of one spline into rectangles.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/cad/cad_piece.hpp"
#include "core/cad/fit/bezier_joint.hpp"
#include "core/cad/fit/spline.hpp"

namespace hariko {

namespace {

/// Longest side of a rectangle, in patches: longer ones make slow systems, and files that are slow to read.
constexpr Index longest_side = 128;
/// Tolerance, relative to the patch's size, below which derivatives of both sides count as those of one
/// spline.
constexpr double same = 1e-10;

/// Tolerance, relative to the wider, below which two widths count as those of one column.
constexpr double same_width = 1e-9;

/// Patch, turned so that its side `turn` is the cell's side 0.
struct Placed {
  Index patch = no_index;
  int turn = 0;
};
/// Patch beyond a side of a cell; `width` is across the side, relative to the cell's own.
struct Neighbour {
  Placed placed;
  double width = 1;
};
bool equal_widths(double a, double b) {
  return std::abs(a - b) <= same_width * std::max(a, b);
}

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
      : surface_(surface),
        bezier_(bezier_patches(surface)),
        degree_(bezier_degree(bezier_).value_or(0)),
        across_(4 * surface.patch_count()),
        width_(4 * surface.patch_count(), 1),
        neighbours_(4 * surface.patch_count()) {
    if (!bezier_.empty()) rounding_ = rounding_of(surface);
    for (const Seam& seam : surface.seams()) {
      neighbours_[slot(seam.first)].push_back(seam.second.patch);
      neighbours_[slot(seam.second)].push_back(seam.first.patch);
      if (seam.first.patch == seam.second.patch) {
        meets_itself_.push_back(seam.first.patch);
        continue;
      }
      const bool whole =
          seam.first_begin == 0 && seam.first_end == 1 && seam.second_begin == 1 && seam.second_end == 0;
      if (!whole || !spline(seam.first.patch) || !spline(seam.second.patch)) continue;
      const std::optional<double> width = width_across(seam);
      if (!width) continue;
      across_[slot(seam.first)] = seam.second;
      across_[slot(seam.second)] = seam.first;
      width_[slot(seam.first)] = *width;
      width_[slot(seam.second)] = 1 / *width;
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
    std::vector<double> widths, heights;
    std::vector<Placed> placed;

    Index columns() const { return Index(widths.size()); }
    Index rows() const { return Index(heights.size()); }
    /// Rectangle of the first columns and rows.
    Rectangle part(Index width, Index height) const {
      Rectangle out{
          {widths.begin(), widths.begin() + width}, {heights.begin(), heights.begin() + height}, {}};
      for (Index row = 0; row < height; ++row)
        out.placed.insert(out.placed.end(), placed.begin() + row * columns(),
                          placed.begin() + row * columns() + width);
      return out;
    }
  };
  struct Row {
    double height = 0;
    std::vector<Placed> placed;
  };

  static std::size_t slot(PatchSide side) { return 4 * std::size_t(side.patch) + side.side; }

  /// Whether the patch is one polynomial of the surface's degree.
  bool spline(Index patch) const {
    if (!bezier_.empty()) return bezier_[patch].degree_s == degree_ && bezier_[patch].degree_t == degree_;
    const ExactForm form = surface_.patches().exact_form(patch);
    const auto* subdivided = std::get_if<SubdivisionPatch>(&form);
    return subdivided ? subdivided->bicubic : std::holds_alternative<BicubicPatch>(form);
  }

  /// Width of the second patch across their seam where the first is 1 wide; nothing where they are not pieces
  /// of one spline.
  std::optional<double> width_across(const Seam& seam) const {
    if (seam.intended == Continuity::g0) return {};
    if (!bezier_.empty())
      return spline_joint(bezier_[seam.first.patch], seam.first.side, bezier_[seam.second.patch],
                          seam.second.side, rounding_);
    return smooth(seam) ? std::optional(1.0) : std::nullopt;
  }

  /// Whether both sides have equal derivatives up to the second; for cubics four places are sufficient.
  bool smooth(const Seam& seam) const {
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

  /// Neighbour beyond side `side` of a cell, turned the same way.
  std::optional<Neighbour> beyond(const Placed& at, int side) const {
    const std::size_t own = slot({at.patch, std::uint8_t((at.turn + side) % 4)});
    const PatchSide other = across_[own];
    if (other.patch == no_index || taken_[other.patch]) return {};
    // The neighbour's side at the seam is the opposite side of its cell.
    return Neighbour{{other.patch, (other.side + 4 - (side + 2) % 4) % 4}, width_[own]};
  }

  static bool contains(const std::vector<Placed>& list, Index patch) {
    return std::any_of(list.begin(), list.end(), [&](const Placed& p) { return p.patch == patch; });
  }

  /// Grows a rectangle: the longest row through a cell, then as many rows as possible.
  Rectangle grow(const Placed& start) {
    Rectangle out{{1}, {1}, {start}};
    std::vector<Placed>& row = out.placed;
    for (const int side : {1, 3}) {
      const bool last = side == 1;
      while (row.size() < longest_side) {
        const auto next = beyond(last ? row.back() : row.front(), side);
        if (!next || contains(row, next->placed.patch)) break;
        const double width = next->width * (last ? out.widths.back() : out.widths.front());
        out.widths.insert(last ? out.widths.end() : out.widths.begin(), width);
        row.insert(last ? row.end() : row.begin(), next->placed);
      }
    }
    std::set<Index> inside;
    for (const Placed& p : row) inside.insert(p.patch);
    for (const int side : {2, 0}) {
      const bool last = side == 2;
      while (out.rows() < longest_side) {
        const Row next = next_row(out, side, inside);
        if (next.placed.empty()) break;
        for (const Placed& p : next.placed) inside.insert(p.patch);
        out.placed.insert(last ? out.placed.end() : out.placed.begin(), next.placed.begin(),
                          next.placed.end());
        out.heights.insert(last ? out.heights.end() : out.heights.begin(), next.height);
      }
    }
    return out;
  }

  /// Row of cells beyond the first or last row; empty where there is none.
  Row next_row(const Rectangle& rectangle, int side, const std::set<Index>& inside) const {
    Row next;
    const std::size_t edge = side == 2 ? rectangle.placed.size() - rectangle.columns() : 0;
    for (std::size_t i = 0; i < rectangle.columns(); ++i) {
      const auto found = beyond(rectangle.placed[edge + i], side);
      if (!found || inside.contains(found->placed.patch) || contains(next.placed, found->placed.patch))
        return {};
      const double height = found->width * (side == 2 ? rectangle.heights.back() : rectangle.heights.front());
      if (i == 0) {
        next.height = height;
      } else {
        const auto along = beyond(next.placed.back(), 1);
        if (!along || along->placed.patch != found->placed.patch ||
            along->placed.turn != found->placed.turn || !equal_widths(height, next.height) ||
            !equal_widths(along->width * rectangle.widths[i - 1], rectangle.widths[i]))
          return {};
      }
      next.placed.push_back(found->placed);
    }
    return next;
  }

  /// Halves a rectangle until it does not meet itself: a closed ring becomes two pieces.
  Rectangle open(Rectangle rectangle) const {
    for (;;) {
      const auto meeting = meeting_sides(rectangle);
      if (!meeting) return rectangle;
      const auto [a, b] = *meeting;
      const Index columns = rectangle.columns(), rows = rectangle.rows();
      const bool by_columns = a % 2 == 1 && b % 2 == 1   ? columns > 1
                              : a % 2 == 0 && b % 2 == 0 ? rows == 1
                                                         : columns >= rows;
      rectangle =
          by_columns ? rectangle.part((columns + 1) / 2, rows) : rectangle.part(columns, (rows + 1) / 2);
    }
  }

  /// Two sides of the rectangle that share a seam, if there are such.
  std::optional<std::pair<int, int>> meeting_sides(const Rectangle& rectangle) const {
    if (rectangle.placed.size() == 1) return {};  // patches that meet themselves were divided before
    std::map<Index, std::set<int>> border;        // the rectangle's sides at each patch
    const auto each = [&](const auto& visit) {
      const Index columns = rectangle.columns(), rows = rectangle.rows();
      for (Index i = 0; i < columns; ++i)
        visit(rectangle.placed[i], 0), visit(rectangle.placed[(rows - 1) * columns + i], 2);
      for (Index j = 0; j < rows; ++j)
        visit(rectangle.placed[j * columns + columns - 1], 1), visit(rectangle.placed[j * columns], 3);
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
    CadPiece piece{breaks_of(rectangle.widths), breaks_of(rectangle.heights), {}, {}};
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
    if (!bezier_.empty())
      for (int side = 0; side < 4; ++side) piece.side_knots[std::size_t(side)] = side_knots(piece, side);
    out.push_back(std::move(piece));
  }

  /// Knots of the curve along a side. Breaks that only one of the two faces has are no knots of their common
  /// curve: otherwise the other face would get them when it is made again.
  std::vector<double> side_knots(const CadPiece& piece, int side) const {
    const std::vector<double> breaks = piece.breaks(side);
    std::vector<double> out{breaks.front()};
    for (Index at = 1; at < piece.cell_count(side); ++at) {
      const PatchSide before = piece.cell(side, at - 1).sides[std::size_t(side)].side,
                      behind = piece.cell(side, at).sides[std::size_t(side)].side;
      const double ratio = (breaks[at + 1] - breaks[at]) / (breaks[at] - breaks[at - 1]);
      if (!one_polynomial(bezier_[before.patch], before.side, bezier_[behind.patch], behind.side, ratio,
                          rounding_))
        out.push_back(breaks[at]);
    }
    out.push_back(breaks.back());
    return out;
  }

  /// Breaks of columns or rows, scaled so that the widest is 1.
  static std::vector<double> breaks_of(const std::vector<double>& widths) {
    const double widest = *std::max_element(widths.begin(), widths.end());
    std::vector<double> out{0};
    for (const double width : widths) out.push_back(out.back() + width / widest);
    return out;
  }

  /// Divides a patch that closes with itself into four pieces.
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
      out.push_back({{0, 1}, {0, 1}, {cell}, {}});
    }
  }

  /// Tolerance of control points that are computed from a neighbour's: the rounding of the numbers in the
  /// file, which continuing a polynomial multiplies by up to 3^8.
  static double rounding_of(const Surface& surface) {
    Eigen::AlignedBox3d box;
    for (Index p = 0; p < surface.patch_count(); ++p)
      for (int k = 0; k < 4; ++k)
        box.extend(surface.patches().evaluate(p, corner_parameter(Domain::square, k), Order::first).position);
    const double farthest = surface.origin().norm() + std::max(box.min().norm(), box.max().norm());
    return std::max(1e-11 * box.diagonal().norm(), 1e3 * std::numeric_limits<double>::epsilon() * farthest);
  }

  const Surface& surface_;
  std::vector<BezierPatch> bezier_;  ///< patches of a surface of Bezier patches, else none
  int degree_;                       ///< degree of Bezier patches that may be joined
  double rounding_ = 0;
  std::vector<PatchSide> across_;  ///< patch side beyond each side, where both are one spline
  std::vector<double> width_;      ///< width of that patch across the side, where the own one is 1
  std::vector<std::vector<Index>> neighbours_;  ///< all patches beyond each side
  std::vector<Index> meets_itself_;
  std::vector<char> taken_;
};

}  // namespace

std::vector<BezierPatch> bezier_patches(const Surface& surface) {
  std::vector<BezierPatch> out;
  for (Index p = 0; p < surface.patch_count(); ++p) {
    ExactForm form = surface.patches().exact_form(p);
    if (auto* patch = std::get_if<BezierPatch>(&form)) out.push_back(std::move(*patch));
  }
  return out;
}

std::optional<int> bezier_degree(const std::vector<BezierPatch>& patches) {
  int degree = patches.empty() ? max_spline_degree + 1 : 1;
  for (const BezierPatch& patch : patches) {
    if (patch.rational()) return {};
    degree = std::max({degree, patch.degree_s, patch.degree_t});
  }
  if (degree > max_spline_degree) return {};
  return degree;
}

std::vector<CadPiece> merged_squares(const Surface& surface) {
  return Merger(surface).run();
}

}  // namespace hariko
