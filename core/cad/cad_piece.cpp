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

/// Distance from a warped corner at which the derivatives along its sides are taken.
constexpr double beside_corner = 1e-4;

/// Point of a cell's bilinear map, with its derivatives.
struct CellPoint {
  Vector2 at, by_s, by_t;
};
CellPoint bilinear_point(const CadCell& cell, double s, double t) {
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

/// Exponent of the warp at a vertex on a smooth border where this many patches meet, 3 or more. What runs in
/// from the border shrinks there as at a vertex of twice the valence, the border's own curve by a half, which
/// asks for no warp: the exponent lies between, nearer to the first.
double border_exponent(int valence) {
  constexpr double share = 0.8;
  return 1 + share * (warp_exponent(2 * valence) - 1);
}

/// Exponents of the warps at the nodes of a Catmull-Clark surface: 1 at regular ones and on sharp edges.
std::vector<double> warp_exponents(const Surface& surface) {
  std::vector<int> valence(surface.node_count(), 0);
  std::vector<char> border(surface.node_count(), 0), sharp(surface.node_count(), 0);
  const auto mark = [&](const PatchSide& side, std::vector<char>& marks) {
    for (const int end : {0, 1}) marks[surface.node(side.patch, (side.side + end) % 4)] = 1;
  };
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (int k = 0; k < 4; ++k) ++valence[surface.node(p, k)];
  for (const PatchSide& side : surface.boundary_sides()) mark(side, border);
  for (const Seam& seam : surface.seams())
    if (seam.intended == Continuity::g0) mark(seam.first, sharp);
  std::vector<double> out(surface.node_count(), 1);
  for (Index node = 0; node < surface.node_count(); ++node)
    if (!sharp[node] && valence[node] > (border[node] ? 2 : 4))
      out[node] = border[node] ? border_exponent(valence[node]) : warp_exponent(valence[node]);
  return out;
}

/// Sets `CadPiece::warps` of the pieces of a Catmull-Clark surface at its extraordinary vertices. O(patches +
/// seams).
void set_warps(const Surface& surface, std::vector<CadPiece>& pieces) {
  const auto is_endless = [&](Index patch) {
    const ExactForm form = surface.patches().exact_form(patch);
    const auto* own = std::get_if<SubdivisionPatch>(&form);
    return own && !own->bicubic;
  };
  const std::vector<double> exponents = warp_exponents(surface);
  for (CadPiece& piece : pieces) {
    if (piece.cells.size() != 1 || !is_endless(piece.cells[0].patch)) continue;
    const CadCell& cell = piece.cells[0];
    std::vector<std::pair<Index, int>> corners;  // by node, the same order in all pieces
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 4; ++j)
        if (cell.corners[std::size_t(k)] == corner_parameter(Domain::square, j))
          corners.emplace_back(surface.node(cell.patch, j), k);
    std::sort(corners.begin(), corners.end());
    for (const auto& [node, k] : corners)
      if (exponents[node] != 1) piece.warps.emplace_back(k, exponents[node]);
  }
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

std::vector<CadPiece> cad_pieces(const Surface& surface, CadPieces which, bool warped) {
  if (surface.patch_count() == 0) return {};
  if (const ChartEvaluation* charts = charts_of(surface)) return chart_pieces(surface.patches(), *charts);
  if (surface.domain() == Domain::square) {
    std::vector<CadPiece> out = merged_squares(surface);
    if (warped) set_warps(surface, out);
    return out;
  }
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
  return piece_->warps.empty() ? cell_point(s, t, order) : warped_point({s, t}, order);
}

PatchPoint PieceEvaluator::warped_point(const Vector2& at, Order order) const {
  const std::vector<CornerWarp>& warps = piece_->warps;
  for (const CornerWarp& warp : warps) {
    if (!warp.is_corner(at)) continue;
    // Derivatives at the corner: of both sides, and none of second order.
    const double inward_s = at.x() > 0 ? -beside_corner : beside_corner,
                 inward_t = at.y() > 0 ? -beside_corner : beside_corner;
    PatchPoint out;
    out.position = cell_point(at.x(), at.y(), Order::first).position;
    out.ds = warped_point({at.x() + inward_s, at.y()}, Order::first).ds;
    out.dt = warped_point({at.x(), at.y() + inward_t}, Order::first).dt;
    return out;
  }
  std::vector<Vector2> places{at};
  for (const CornerWarp& warp : warps) places.push_back(warp.map(places.back()));
  PatchPoint out = cell_point(places.back().x(), places.back().y(), order);
  for (std::size_t i = warps.size(); i-- > 0;) out = warps[i].pull_back(out, places[i], order);
  return out;
}

/// Point by the parameters before warping.
PatchPoint PieceEvaluator::cell_point(double s, double t, Order order) const {
  const CadPiece& piece = *piece_;
  const std::size_t column = span_of(piece.s, s), row = span_of(piece.t, t);
  const CadCell& cell = piece.cells[row * piece.columns() + column];
  const double width = piece.s[column + 1] - piece.s[column], height = piece.t[row + 1] - piece.t[row];
  const CellPoint at = bilinear_point(cell, (s - piece.s[column]) / width, (t - piece.t[row]) / height);
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
