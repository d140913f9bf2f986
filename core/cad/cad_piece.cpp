#include "core/cad/cad_piece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

const ChartEvaluation* charts_of(const Surface& surface) {
  const ExactForm form = surface.patches().exact_form(0);
  const auto* chart = std::get_if<ChartPatch>(&form);
  return chart ? chart->charts : nullptr;
}

/// Point of a cell's bilinear map, with its derivatives.
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

/// Number of the interval between breaks that contains x; at a break the upper one.
std::size_t span_of(const std::vector<double>& breaks, double x) {
  const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, x);
  return std::size_t(above - breaks.begin()) - 1;
}

/// Makes a `CellSide` of part of side `side` of a patch.
CellSide on(Index patch, int side, double begin, double end) {
  return {{patch, std::uint8_t(side)}, begin, end, no_index};
}
CellSide inside(Index number, bool forward) {
  return {{}, forward ? 0.0 : 1.0, forward ? 1.0 : 0.0, number};
}

/// Three quads of a triangle: corner, middle of the side, centre, middle of the side before. `inner`: number
/// of the first inner curve.
void add_thirds(Index patch, Index inner, std::vector<CadPiece>& out) {
  const Vector2 centre(1.0 / 3, 1.0 / 3);
  for (int k = 0; k < 3; ++k) {
    const int before = (k + 2) % 3;
    CadCell cell;
    cell.patch = patch;
    cell.corners = {corner_parameter(Domain::triangle, k), side_parameter(Domain::triangle, k, 0.5), centre,
                    side_parameter(Domain::triangle, before, 0.5)};
    cell.sides = {on(patch, k, 0, 0.5), inside(inner + Index(k), true), inside(inner + Index(before), false),
                  on(patch, before, 0.5, 1)};
    out.push_back({{0, 1}, {0, 1}, {cell}, {}});
  }
}

/// Pieces of a face given as triangles round its middle, whose side 1 is the face's and corner 0 the middle.
/// A square is one piece; other faces are cut into quads: corner, middle of the side, centre, middle of the
/// side before.
void add_polygon(const std::vector<Index>& patches, const std::vector<Vector2>& vertices, const CadCell& kind,
                 Index inner, std::vector<CadPiece>& out) {
  const std::size_t n = patches.size();
  CadCell cell = kind;
  if (n == 4) {
    for (std::size_t k = 0; k < n; ++k) {
      cell.corners[k] = vertices[k];
      cell.sides[k] = on(patches[k], 1, 0, 1);
    }
    out.push_back({{0, 1}, {0, 1}, {cell}, {}});
    return;
  }
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = (k + n - 1) % n, after = (k + 1) % n;
    cell.corners = {vertices[k], 0.5 * (vertices[k] + vertices[after]), Vector2::Zero(),
                    0.5 * (vertices[before] + vertices[k])};
    cell.sides = {on(patches[k], 1, 0, 0.5), inside(inner + Index(k), true),
                  inside(inner + Index(before), false), on(patches[before], 1, 0.5, 1)};
    out.push_back({{0, 1}, {0, 1}, {cell}, {}});
  }
}

std::vector<CadPiece> chart_pieces(const PatchSet& patches, const ChartEvaluation& charts) {
  std::map<Index, std::map<int, Index>> faces;  // patch of each side of each face
  for (Index p = 0; p < patches.patch_count(); ++p) {
    const auto chart = std::get<ChartPatch>(patches.exact_form(p));
    faces[chart.face][chart.side] = p;
  }
  std::vector<CadPiece> out;
  Index inner = 0;
  for (const auto& [face, of_side] : faces) {
    CadCell cell;
    cell.patch = face;
    cell.chart = true;
    std::vector<Index> own;
    for (const auto& [side, patch] : of_side) own.push_back(patch);
    add_polygon(own, charts.polygon(face), cell, inner, out);
    inner += Index(own.size());
  }
  return out;
}

/// Corner k of a regular n-gon of radius 1.
Vector2 fan_vertex(std::size_t k, std::size_t n) {
  const double turn = 2 * std::numbers::pi * double(k % n) / double(n);
  return {std::cos(turn), std::sin(turn)};
}

/// Triangles of one face, in order, that meet smoothly round their first corners; every other triangle is
/// alone.
std::vector<std::vector<Index>> fans_of(const Surface& surface) {
  // Triangle beyond side 2 of each triangle, where that side meets its side 0.
  std::vector<Index> next(surface.patch_count(), no_index);
  for (const Seam& seam : surface.seams()) {
    const bool whole =
        seam.first_begin == 0 && seam.first_end == 1 && seam.second_begin == 1 && seam.second_end == 0;
    if (!whole || seam.intended == Continuity::g0) continue;
    if (seam.first.side == 2 && seam.second.side == 0) next[seam.first.patch] = seam.second.patch;
    if (seam.first.side == 0 && seam.second.side == 2) next[seam.second.patch] = seam.first.patch;
  }
  std::vector<std::vector<Index>> out;
  std::vector<char> taken(surface.patch_count(), 0);
  for (Index p = 0; p < surface.patch_count(); ++p) {
    if (taken[p]) continue;
    std::vector<Index> fan;
    Index at = p;
    do {
      fan.push_back(at);
      at = next[at];
    } while (at != no_index && at != p && !taken[at] && fan.size() <= surface.patch_count());
    if (at != p || fan.size() < 3) fan = {p};
    for (const Index patch : fan) taken[patch] = 1;
    out.push_back(std::move(fan));
  }
  return out;
}

std::vector<CadPiece> fan_pieces(const Surface& surface) {
  std::vector<CadPiece> out;
  Index inner = 0;
  for (const std::vector<Index>& fan : fans_of(surface)) {
    if (fan.size() == 1) {
      add_thirds(fan.front(), inner, out);
      inner += 3;
      continue;
    }
    CadCell cell;
    cell.patch = fan.front();
    cell.fan = fan;
    std::vector<Vector2> vertices;
    for (std::size_t k = 0; k < fan.size(); ++k) vertices.push_back(fan_vertex(k, fan.size()));
    add_polygon(fan, vertices, cell, inner, out);
    inner += Index(fan.size());
  }
  return out;
}

/// Derivatives by new variables p and q; the present parameters are linear functions of them with rows `by_p`
/// and `by_q`.
PatchPoint by_linear(const PatchPoint& point, const Vector2& by_p, const Vector2& by_q) {
  const auto second = [&](const Vector2& a, const Vector2& b) -> Vector3 {
    return a.x() * b.x() * point.dss + (a.x() * b.y() + a.y() * b.x()) * point.dst +
           a.y() * b.y() * point.dtt;
  };
  PatchPoint out;
  out.position = point.position;
  out.ds = by_p.x() * point.ds + by_p.y() * point.dt;
  out.dt = by_q.x() * point.ds + by_q.y() * point.dt;
  out.dss = second(by_p, by_p);
  out.dst = second(by_p, by_q);
  out.dtt = second(by_q, by_q);
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

std::vector<CadPiece> cad_pieces(const Surface& surface, CadPieces which) {
  if (surface.patch_count() == 0) return {};
  if (const ChartEvaluation* charts = charts_of(surface)) return chart_pieces(surface.patches(), *charts);
  if (surface.domain() == Domain::square) return merged_squares(surface);
  if (which == CadPieces::faces) return fan_pieces(surface);
  std::vector<CadPiece> out;
  for (Index p = 0; p < surface.patch_count(); ++p) add_thirds(p, 3 * p, out);
  return out;
}

PieceEvaluator::PieceEvaluator(const Surface& surface, const CadPiece& piece)
    : patches_(&surface.patches()), charts_(charts_of(surface)), piece_(&piece) {
  const std::size_t n = piece.cells.front().fan.size();
  for (std::size_t k = 0; k < n; ++k) polygon_.push_back(fan_vertex(k, n));
}

PatchPoint PieceEvaluator::patch_point(Index patch, const Vector2& at, Order order) const {
  if (order == Order::second) return patches_->evaluate(patch, at, order);
  PatchPoint out;
  patches_->first_order(patch, {&at, 1}, {&out, 1});
  return out;
}

/// Point and derivatives by the coordinates of the fan's polygon.
PatchPoint PieceEvaluator::fan_point(const CadCell& cell, const Vector2& at, Order order) const {
  const std::size_t n = polygon_.size();
  const auto cross = [](const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); };
  std::size_t k = 0;
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    const double inside = std::min(cross(polygon_[i], at), cross(at, polygon_[(i + 1) % n]));
    if (inside > deepest) deepest = inside, k = i;
  }
  const Vector2 &a = polygon_[k], &b = polygon_[(k + 1) % n];
  const double area = cross(a, b);
  Vector2 parameter(cross(at, b) / area, cross(a, at) / area);
  parameter = parameter.cwiseMax(0.0);
  if (parameter.sum() > 1) parameter /= parameter.sum();
  return by_linear(patch_point(cell.fan[k], parameter, order), Vector2(b.y(), -a.y()) / area,
                   Vector2(-b.x(), a.x()) / area);
}

PatchPoint PieceEvaluator::at(double s, double t, Order order) const {
  const CadPiece& piece = *piece_;
  const std::size_t column = span_of(piece.s, s), row = span_of(piece.t, t);
  const CadCell& cell = piece.cells[row * piece.columns() + column];
  const double width = piece.s[column + 1] - piece.s[column], height = piece.t[row + 1] - piece.t[row];
  const CellPoint at = cell_point(cell, (s - piece.s[column]) / width, (t - piece.t[row]) / height);
  const PatchPoint point = !cell.fan.empty() ? fan_point(cell, at.at, order)
                           : cell.chart      ? charts_->evaluate_chart(cell.patch, at.at, order)
                                             : patch_point(cell.patch, at.at, order);
  PatchPoint out = by_linear(point, at.by_s / width, at.by_t / height);
  if (order == Order::second) {  // the cell's map is bilinear
    const auto& c = cell.corners;
    const Vector2 twist = (c[0] - c[1] + c[2] - c[3]) / (width * height);
    out.dst += twist.x() * point.ds + twist.y() * point.dt;
  }
  return out;
}

}  // namespace hariko
