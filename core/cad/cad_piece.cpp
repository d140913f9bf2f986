#include "core/cad/cad_piece.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/g2/g2_patch_set.hpp"

namespace hariko {

namespace {

const G2PatchSet* g2_patches(const Surface& surface) {
  return dynamic_cast<const G2PatchSet*>(&surface.patches());
}

/// Bilinear map of a cell with its derivatives.
struct CellPoint {
  Vector2 at, by_s, by_t;
};
CellPoint cell_point(const CadCell& cell, double s, double t) {
  const auto& c = cell.corners;
  CellPoint out;
  out.at = (1 - t) * ((1 - s) * c[0] + s * c[1]) + t * ((1 - s) * c[3] + s * c[2]);
  out.by_s = (1 - t) * (c[1] - c[0]) + t * (c[2] - c[3]);
  out.by_t = (1 - s) * (c[3] - c[0]) + s * (c[2] - c[1]);
  return out;
}

/// The number of the stretch between breaks that x lies in; of two at a break the upper one.
std::size_t span_of(const std::vector<double>& breaks, double x) {
  const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, x);
  return std::size_t(above - breaks.begin()) - 1;
}

/// Part of side `side` of a patch.
CellSide on(Index patch, int side, double begin, double end) {
  return {{patch, std::uint8_t(side)}, begin, end, no_index};
}
CellSide inside(Index number, bool forward) {
  return {{}, forward ? 0.0 : 1.0, forward ? 1.0 : 0.0, number};
}

/// Three quads of a triangle: corner, middle of the side, centre, middle of the side before.
void add_thirds(Index patch, std::vector<CadPiece>& out) {
  const Vector2 centre(1.0 / 3, 1.0 / 3);
  for (int k = 0; k < 3; ++k) {
    const int before = (k + 2) % 3;
    CadCell cell;
    cell.patch = patch;
    cell.corners = {corner_parameter(Domain::triangle, k), side_parameter(Domain::triangle, k, 0.5), centre,
                    side_parameter(Domain::triangle, before, 0.5)};
    cell.sides = {on(patch, k, 0, 0.5), inside(3 * patch + Index(k), true),
                  inside(3 * patch + Index(before), false), on(patch, before, 0.5, 1)};
    out.push_back({{0, 1}, {0, 1}, {cell}, {}});
  }
}

/// Quads of the faces of mode G2, which are smooth across the patches' inner sides: corner, middle of the
/// side, centre, middle of the side before.
std::vector<CadPiece> chart_pieces(const G2PatchSet& patches) {
  const G2Atlas& atlas = *patches.atlas();
  std::vector<std::vector<Index>> of_face(atlas.chart.size());
  for (Index p = 0; p < patches.patch_count(); ++p) {
    auto& list = of_face[atlas.face[p]];
    list.resize(std::size_t(atlas.chart[atlas.face[p]]->sides()), no_index);
    list[std::size_t(atlas.side[p])] = p;
  }
  std::vector<CadPiece> out;
  Index first_inner = 0;
  for (Index f = 0; f < of_face.size(); ++f) {
    const FaceChart& chart = *atlas.chart[f];
    const auto n = Index(chart.sides());
    const auto vertex = [&](Index k) -> Vector2 { return chart.vertex(int(k % n)); };
    for (Index k = 0; k < n; ++k) {
      const Index before = (k + n - 1) % n;
      CadCell cell;
      cell.patch = f;
      cell.chart = true;
      cell.corners = {vertex(k), 0.5 * (vertex(k) + vertex(k + 1)), Vector2::Zero(),
                      0.5 * (vertex(before) + vertex(k))};
      // Side 1 of a patch is the face's: corner 0 is the centre.
      cell.sides = {on(of_face[f][k], 1, 0, 0.5), inside(first_inner + k, true),
                    inside(first_inner + before, false), on(of_face[f][before], 1, 0.5, 1)};
      out.push_back({{0, 1}, {0, 1}, {cell}, {}});
    }
    first_inner += n;
  }
  return out;
}

}  // namespace

const CadCell& CadPiece::cell(int side, Index at) const {
  switch (side) {
    case 0:
      return cells[at];
    case 1:
      return cells[at * columns() + columns() - 1];
    case 2:
      return cells[(rows() - 1) * columns() + columns() - 1 - at];
    default:
      return cells[(rows() - 1 - at) * columns()];
  }
}

std::vector<double> CadPiece::breaks(int side) const {
  const std::vector<double>& upward = side % 2 == 0 ? s : t;
  if (side < 2) return upward;
  std::vector<double> out;
  for (auto at = upward.rbegin(); at != upward.rend(); ++at) out.push_back(upward.back() - *at);
  return out;
}

Vector2 CadPiece::parameter(int side, double x) const {
  switch (side) {
    case 0:
      return {x, 0};
    case 1:
      return {s.back(), x};
    case 2:
      return {s.back() - x, t.back()};
    default:
      return {0, t.back() - x};
  }
}

std::vector<CadPiece> cad_pieces(const Surface& surface) {
  if (surface.patch_count() == 0) return {};
  if (const G2PatchSet* g2 = g2_patches(surface)) return chart_pieces(*g2);
  if (surface.domain() == Domain::square) return merged_squares(surface);
  std::vector<CadPiece> out;
  for (Index p = 0; p < surface.patch_count(); ++p) add_thirds(p, out);
  return out;
}

PatchPoint evaluate(const Surface& surface, const CadPiece& piece, double s, double t) {
  const std::size_t column = span_of(piece.s, s), row = span_of(piece.t, t);
  const CadCell& cell = piece.cells[row * piece.columns() + column];
  const double width = piece.s[column + 1] - piece.s[column], height = piece.t[row + 1] - piece.t[row];
  const CellPoint at = cell_point(cell, (s - piece.s[column]) / width, (t - piece.t[row]) / height);
  PatchPoint point = cell.chart ? g2_patches(surface)->evaluate_chart(cell.patch, at.at, Order::first)
                                : surface.patches().evaluate(cell.patch, at.at, Order::first);
  const Vector3 by_s = (at.by_s.x() * point.ds + at.by_s.y() * point.dt) / width;
  const Vector3 by_t = (at.by_t.x() * point.ds + at.by_t.y() * point.dt) / height;
  point.ds = by_s;
  point.dt = by_t;
  return point;
}

}  // namespace hariko
