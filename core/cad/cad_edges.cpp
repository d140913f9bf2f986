#include "core/cad/cad_edges.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/base/disjoint_sets.hpp"
#include "core/base/parallel.hpp"
#include "core/cad/fit/side_tie.hpp"

namespace hariko {

namespace {

/// Cosine of the angle below which normals at a vertex count as equal.
constexpr double common_normal = 0.9999;

}  // namespace

void insert_break(std::vector<double>& breaks, double at) {
  const auto above = std::lower_bound(breaks.begin(), breaks.end(), at - 1e-9);
  if (above != breaks.end() && *above <= at + 1e-9) return;
  breaks.insert(above, at);
}

CadEdges::CadEdges(const EdgeTask& task, const CadPlan& plan, const CancelToken& cancel)
    : task_(task), sides_(plan.sides) {
  task_.limits.distance *= curve_share;
  take(plan);
  bend_ends();
  fit_divided_sides(cancel);
  parallel_for(edges_.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end && !cancel.cancelled(); ++e) fit(edges_[e]);
  });
  take_vertices(plan.vertex_count);
}

TracedPoint CadEdges::side_point(Index number, int side, double x, bool smooth) const {
  const CadPiece& own = (*task_.pieces)[number];
  const Vector2 at = own.parameter(side, x);
  const PatchPoint p = (*task_.points)[number].at(at.x(), at.y());
  const Vector3 along = side % 2 == 0 ? p.ds : p.dt;
  static const std::optional<End> none;
  TracedPoint out{p.position, side < 2 ? along : Vector3(-along)};
  if (!has_normal(p)) return out;
  if (smooth) out.normal = unit_normal(p);
  const auto& ends = ends_[number][std::size_t(side)];
  const auto& end = x <= 0 ? ends[0] : x >= own.length(side) ? ends[1] : none;
  if (end) out.normal = end->normal, out.bend = end->wanted;
  return out;
}

/// Limits from inside the edge, as patches may have other derivatives at the corner itself.
CadEdges::End CadEdges::end_of(const CadEdge& edge, bool at_end) const {
  const CadUse& use = edge.uses[0];
  const CadPiece& own = piece(use);
  End out;
  std::array<Vector3, 3> normals, directions;
  // Curvature grows without bounds toward most extraordinary vertices: there it is that of the first stretch.
  const double inward = own.warps.empty() ? 1e-3 : 2e-2;
  const double from = at_end ? use.end : use.begin,
               step = (at_end ? -inward : inward) * (use.end - use.begin);
  double speed = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector2 at = own.parameter(use.side, from + double(k + 1) * step);
    const PatchPoint p = (*task_.points)[use.piece].at(at.x(), at.y());
    if (!has_normal(p)) return out;
    const Vector3 along = (use.side % 2 == 0 ? p.ds : p.dt) * (use.side < 2 ? 1 : -1) * (at_end ? -1 : 1);
    normals[k] = unit_normal(p);
    directions[k] = along.stableNormalized();
    if (k == 0) speed = along.norm();
  }
  // Extrapolation by parabolas through three places.
  out.normal = (3 * normals[0] - 3 * normals[1] + normals[2]).normalized();
  out.direction = (3 * directions[0] - 3 * directions[1] + directions[2]).normalized();
  const Vector3 turned = (4 * normals[1] - normals[2] - 3 * normals[0]) / (2 * std::abs(step));
  out.bend = -turned.dot(directions[0]) / speed;
  return out;
}

/// Corner of a piece, four a piece, at which a use of an edge ends; nothing where its side runs on there.
std::optional<Index> CadEdges::corner_of(const CadEdge& edge, std::size_t use, bool at_end) const {
  const CadUse& own = edge.uses[use];
  const bool side_end = (use == 0) == at_end;
  if (!ends_side(own, side_end)) return {};
  return 4 * own.piece + Index((own.side + (side_end ? 1 : 0)) % 4);
}

std::vector<CadEdges::Sector> CadEdges::sectors() const {
  DisjointSets sets(4 * sides_.size());
  for (const CadEdge& edge : edges_)
    for (const bool at_end : {false, true}) {
      if (!edge.smooth || edge.use_count < 2) continue;
      const auto first = corner_of(edge, 0, at_end), second = corner_of(edge, 1, at_end);
      if (first && second) sets.join(*first, *second);
    }
  std::vector<Sector> out(4 * sides_.size());
  for (Index e = 0; e < edges_.size(); ++e) {
    const CadEdge& edge = edges_[e];
    for (const bool at_end : {false, true}) {
      const auto first = corner_of(edge, 0, at_end);
      const auto second = edge.use_count == 2 ? corner_of(edge, 1, at_end) : first;
      const bool crease = edge.use_count == 2 && !edge.smooth, torn = bool(first) != bool(second);
      for (const auto& corner : {first, second}) {
        if (!corner) continue;
        Sector& sector = out[sets.find(*corner)];
        sector.creased = sector.creased || crease;
        sector.torn = sector.torn || torn;
        sector.closed = sector.closed && edge.use_count == 2;
        if (sector.ends.empty() || sector.ends.back().edge != e || sector.ends.back().at_end != at_end)
          sector.ends.push_back({e, at_end});
      }
    }
  }
  return out;
}

/// Prescribes normal curvatures in sectors of smooth edges: those of the one quadratic form nearest to the
/// surface's curvatures. Otherwise no smooth faces with continuous second derivatives exist between the
/// curves (vertex enclosure problem), and knots would accumulate there. Sectors that end at borders need it
/// only where faces are to have curvatures in common.
void CadEdges::bend_ends() {
  ends_.resize(sides_.size());
  for (const Sector& sector : sectors()) {
    const bool common = std::isfinite(task_.limits.bend);
    if (sector.creased || sector.torn || sector.ends.size() < (common && sector.closed ? 2 : 3)) continue;
    if (!sector.closed && !common) continue;
    std::vector<End> ends;
    Vector3 normal = Vector3::Zero();
    for (const EdgeEnd& at : sector.ends) {
      ends.push_back(end_of(edges_[at.edge], at.at_end));
      normal += ends.back().normal;
    }
    normal.stableNormalize();
    const bool smooth = std::all_of(ends.begin(), ends.end(),
                                    [&](const End& end) { return end.normal.dot(normal) > common_normal; });
    if (smooth) bend_sector(sector, ends, normal);
  }
}

void CadEdges::bend_sector(const Sector& sector, const std::vector<End>& ends, const Vector3& normal) {
  const Vector3 x = normal.unitOrthogonal(), y = normal.cross(x);
  Eigen::MatrixXd rows(Eigen::Index(ends.size()), 3);
  Eigen::VectorXd bends(Eigen::Index(ends.size()));
  for (Eigen::Index k = 0; k < bends.size(); ++k) {
    const Vector3& d = ends[std::size_t(k)].direction;
    rows.row(k) << d.dot(x) * d.dot(x), 2 * d.dot(x) * d.dot(y), d.dot(y) * d.dot(y);
    bends[k] = ends[std::size_t(k)].bend;
  }
  const Eigen::VectorXd common = rows * rows.colPivHouseholderQr().solve(bends);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const auto [e, at_end] = sector.ends[k];
    for (std::size_t u = 0; u < std::size_t(edges_[e].use_count); ++u) {
      auto& end = end_at(edges_[e], u, at_end);
      end = End{ends[k].direction, normal, ends[k].bend};
      if (task_.bends) end->wanted = common[Eigen::Index(k)];
    }
  }
}

/// Fits the curve of one side. `spline`: its space where the surface is a spline there; otherwise the fit
/// begins with `start`.
FittedCurve CadEdges::curve(const SplineSpace& spline, const SplineSpace& start, Index number, int side,
                            bool smooth) const {
  const auto function = [&](double x) { return side_point(number, side, x, smooth); };
  const auto& ends = ends_[number][std::size_t(side)];
  const auto stays = [&](const std::optional<End>& end) {
    const double length = (function(spline.end()).position - function(spline.begin()).position).norm();
    return !end || !end->wanted ||
           std::abs(*end->wanted - end->bend) * length * length < task_.limits.distance;
  };
  if (!stays(ends[0]) || !stays(ends[1])) return fit_curve(start, function, task_.limits);
  if (auto equal = equal_curve(spline, function, 0.5 * task_.rounding)) return {std::move(*equal), true};
  return fit_curve(start, function, task_.limits);
}

void CadEdges::take(const CadPlan& plan) {
  for (const PlannedEdge& planned : plan.edges) {
    CadEdge edge;
    edge.begin = planned.begin;
    edge.end = planned.end;
    edge.uses = planned.uses;
    edge.use_count = planned.use_count;
    edge.smooth = planned.smooth;
    edges_.push_back(std::move(edge));
  }
}

/// Fits one curve along each side with several edges; these edges take parts of it.
void CadEdges::fit_divided_sides(const CancelToken& cancel) {
  divided_.resize(sides_.size());
  parallel_for(sides_.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end && !cancel.cancelled(); ++p)
      for (int side = 0; side < 4; ++side) {
        const auto& list = sides_[p][std::size_t(side)];
        if (list.size() < 2) continue;
        const bool smooth = std::all_of(list.begin(), list.end(), [&](Index e) { return edges_[e].smooth; });
        const SplineSpace space{task_.degree, (*task_.pieces)[p].knots(side)};
        divided_[p][std::size_t(side)] = curve(space, space, Index(p), side, smooth).curve;
      }
  });
}

void CadEdges::fit(CadEdge& edge) const {
  const CadUse &first = edge.uses[0], &second = edge.uses[1];
  const bool two = edge.use_count == 2;
  const double span = first.end - first.begin;
  if (!whole(first)) {
    edge.curve = part(first);
  } else if (two && !whole(second)) {
    edge.curve = reversed(part(second));
    for (double& b : edge.curve.space.breaks) b *= span / (second.end - second.begin);
  } else {
    SplineSpace start{task_.degree, piece(first).knots(first.side)};
    if (two) {
      const SplineSpace other{task_.degree, piece(second).knots(second.side)};
      for (const double b : other.reversed().breaks) insert_break(start.breaks, b * span / length(second));
    }
    edge.curve = curve(start, start, first.piece, first.side, two && edge.smooth).curve;
  }
  edge.curve.space.breaks.back() = span;
}

/// Part of the curve of a divided side, reparametrised to begin at 0.
SplineCurve CadEdges::part(const CadUse& use) const {
  const SplineCurve& all = divided_[use.piece][std::size_t(use.side)];
  SplineSpace space{task_.degree, {0}};
  for (const double b : all.space.breaks)
    if (b > use.begin && b < use.end) space.breaks.push_back(b - use.begin);
  space.breaks.push_back(use.end - use.begin);
  const SplineInterpolation interpolation(space);
  SplineCurve out{space, {}};
  for (const double x : interpolation.places()) out.points.push_back(evaluate(all, use.begin + x).position);
  interpolation.solve(out.points, 1, 1, 0);
  return out;
}

/// Places vertices at the ends of the parts of divided sides, elsewhere at the end of the first edge, and
/// sets the ends of all curves to them.
void CadEdges::take_vertices(Index count) {
  vertices_.resize(count);
  std::vector<char> known(count, 0);
  const auto take = [&](Index vertex, const Vector3& position) {
    if (known[vertex]) return;
    known[vertex] = 1;
    vertices_[vertex] = position;
  };
  for (const bool parts : {true, false})
    for (const CadEdge& edge : edges_) {
      const bool is_part = !whole(edge.uses[0]) || (edge.use_count == 2 && !whole(edge.uses[1]));
      if (is_part != parts || edge.curve.points.empty()) continue;
      take(edge.begin, edge.curve.points.front());
      take(edge.end, edge.curve.points.back());
    }
  for (CadEdge& edge : edges_) {
    if (edge.curve.points.empty()) continue;  // cancelled
    edge.curve.points.front() = vertices_[edge.begin];
    edge.curve.points.back() = vertices_[edge.end];
    const auto shrunk = [&](const Vector3& p) {
      return (p - edge.curve.points.front()).norm() <= 100 * task_.rounding;
    };
    edge.degenerate =
        edge.use_count == 1 && std::all_of(edge.curve.points.begin(), edge.curve.points.end(), shrunk);
  }
}

SplineCurve CadEdges::along(const CadEdge& edge, Index number, int side) const {
  const bool first = is_first(edge, number, side);
  const CadUse& use = edge.uses[first ? 0 : 1];
  SplineCurve out = first ? edge.curve : reversed(edge.curve);
  const double scale = (use.end - use.begin) / (edge.uses[0].end - edge.uses[0].begin);
  if (scale != 1)
    for (double& b : out.space.breaks) b *= scale;
  return out;
}

SplineCurve CadEdges::side_curve(Index number, int side) const {
  const auto& list = sides_[number][std::size_t(side)];
  if (list.size() == 1) return along(edges_[list.front()], number, side);
  SplineCurve out = divided_[number][std::size_t(side)];
  const auto vertex = [&](Index e, bool end) {
    return vertices_[end == is_first(edges_[e], number, side) ? edges_[e].end : edges_[e].begin];
  };
  out.points.front() = vertex(list.front(), false);
  out.points.back() = vertex(list.back(), true);
  return out;
}

std::vector<Vector3> CadEdges::boundary(Index number, int side, const SplineSpace& space) const {
  const SplineCurve curve = side_curve(number, side);
  const bool against = side >= 2;  // counter-clockwise is against s and t there
  const auto& list = sides_[number][std::size_t(side)];
  const bool turned = list.size() == 1 && !is_first(edges_[list.front()], number, side);
  const SplineSpace counter_clockwise = against ? space.reversed() : space;
  SplineCurve solved = turned ? reversed(in_space(reversed(curve), counter_clockwise.reversed()))
                              : in_space(curve, counter_clockwise);
  if (against) std::reverse(solved.points.begin(), solved.points.end());
  return std::move(solved.points);
}

std::vector<double> CadEdges::breaks(Index number, int side) const {
  const SplineSpace space = side_curve(number, side).space;
  return side < 2 ? space.breaks : space.reversed().breaks;
}

}  // namespace hariko
