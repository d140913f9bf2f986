#include "core/cad/fit/edge_ties.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hariko {

namespace {

/// Weight of ties relative to the distance inside; the first rows of control points are to meet them.
constexpr double tie_share = 4;
/// Weight of the length and the lean of the derivative across a side, relative to the angle.
constexpr double slope_share = 0.05;

/// Sine of the angle between an edge and the derivative across it below which a place counts less: sides of
/// the corner run on almost straight there.
constexpr double straight_sine = 0.05;

/// Place nearest to x.
const EdgePlace* nearest(const std::vector<EdgePlace>& places, double x) {
  if (places.empty()) return nullptr;
  const auto above =
      std::lower_bound(places.begin(), places.end(), x, [](const EdgePlace& p, double y) { return p.x < y; });
  if (above == places.end()) return &places.back();
  return above == places.begin() || above->x - x < x - above[-1].x ? &*above : &above[-1];
}

}  // namespace

bool EdgeTies::tied(Index number) const {
  const CadEdge& edge = edges_.edges()[number];
  return edge.smooth && edge.use_count == 2 &&
         (faces_.free(edge.uses[0].piece) || faces_.free(edge.uses[1].piece));
}

double EdgeTies::on_side(const CadEdge& edge, int use, double x) {
  const CadUse& own = edge.uses[std::size_t(use)];
  const double f = x / edge.curve.space.end();
  return own.begin + (use == 0 ? f : 1 - f) * (own.end - own.begin);
}

double EdgeTies::growing(const CadEdge& edge, int use, double x) const {
  const CadUse& own = edge.uses[std::size_t(use)];
  const double along = on_side(edge, use, x);
  return own.side < 2 ? along : length(own) - along;
}

std::size_t EdgeTies::span(const CadEdge& edge, int use, double x) const {
  const CadUse& own = edge.uses[std::size_t(use)];
  const SplineSurface& face = faces_.surface(own.piece);
  return (own.side % 2 == 0 ? face.s : face.t).span(growing(edge, use, x));
}

/// Breaks of both faces along an edge, in the edge's parameter.
std::vector<double> EdgeTies::edge_breaks(const CadEdge& edge) const {
  const double span = edge.curve.space.end();
  std::vector<double> out{0, span};
  for (int u = 0; u < 2; ++u) {
    const CadUse& use = edge.uses[std::size_t(u)];
    const SplineSurface& face = faces_.surface(use.piece);
    for (const double b : (use.side % 2 == 0 ? face.s : face.t).breaks) {
      const double along = use.side < 2 ? b : length(use) - b;
      const double f = (along - use.begin) / (use.end - use.begin);
      if (f > 0 && f < 1) insert_break(out, (u == 0 ? f : 1 - f) * span);
    }
  }
  return out;
}

void EdgeTies::place(Index number) {
  const CadEdge& edge = edges_.edges()[number];
  const std::vector<EdgePlace> before = std::move(places_[number]);
  auto& list = places_[number];
  list.clear();
  const SpanPlaces& gauss = span_places(task_.degree + 3);
  const std::vector<double> breaks = edge_breaks(edge);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    for (std::size_t g = 0; g < gauss.at.size(); ++g) {
      EdgePlace at;
      const double width = breaks[k + 1] - breaks[k];
      at.x = breaks[k] + gauss.at[g] * width;
      at.width = gauss.weight[g] * width / edge.curve.space.end();
      if (!measure(edge, at)) continue;
      tie_turn(edge, at);
      at.bend.weight = at.turn.weight;
      at.bend.free = at.turn.free;
      if (const EdgePlace* old = nearest(before, at.x)) {
        at.turn.wanted = old->turn.wanted;
        // Curvatures are compared as far as the planes agree: where a face all but folds, ties of curvature
        // would draw it farther from the surface.
        const double off = std::max(1.0, miss(*old));
        at.bend.limit *= off * off;
      }
      list.push_back(std::move(at));
    }
}

PatchPoint EdgeTies::side_point(const CadUse& use, double x) const {
  const Vector2 at = (*task_.pieces)[use.piece].parameter(use.side, x);
  return (*task_.points)[use.piece].at(at.x(), at.y(), bends() ? Order::second : Order::first);
}

/// Computes normal and speeds; false where there is no normal.
bool EdgeTies::measure(const CadEdge& edge, EdgePlace& at) const {
  const SplinePoint curve = evaluate(edge.curve, at.x);
  std::array<PatchPoint, 2> points;
  const Vector3 tangent = curve.derivative.stableNormalized();
  for (int u = 0; u < 2; ++u) {
    const CadUse& use = edge.uses[std::size_t(u)];
    // The curve's parametrisation may run ahead of the surface's.
    double x = on_side(edge, u, at.x);
    const PatchPoint near = side_point(use, x);
    const Vector3 along = (use.side % 2 == 0 ? near.ds : near.dt) * (use.side < 2 ? 1 : -1);
    x += (curve.position - near.position).dot(along) / along.squaredNorm();
    const PatchPoint p = side_point(use, std::clamp(x, 0.0, length(use)));
    if (!has_normal(near) || !has_normal(p)) return false;
    at.across[std::size_t(u)] = use.side % 2 == 0 ? p.dt : p.ds;
    at.normal += unit_normal(p);
    points[std::size_t(u)] = p;
  }
  at.normal = (at.normal - at.normal.dot(tangent) * tangent).stableNormalized();
  at.left = at.normal.cross(tangent);
  for (std::size_t u = 0; u < 2; ++u) {
    at.speed[u] = at.across[u].dot(at.left);
    const double sine = std::abs(at.speed[u]) / at.across[u].norm();
    if (!(sine > 1e-5)) return false;
    at.sine = std::min(at.sine, sine / straight_sine);
  }
  if (!bends()) return true;
  double whole = 1 / task_.size, narrow = std::numeric_limits<double>::infinity();
  for (int u = 0; u < 2; ++u) {
    narrow = std::min(narrow, narrowest(edge, u, at.x, points[std::size_t(u)]));
    const NormalBend bend = normal_bend(points[std::size_t(u)], at.left);
    at.bend.wanted += bend.across / 2;
    whole = std::max(whole, bend.largest);
    tie_bend(edge, at, u, points[std::size_t(u)]);
  }
  // A deviation of `distance` over one span bends a face by this much: narrower knots would only increase it.
  at.bend.limit = (limits_.bend * whole + limits_.distance / (narrow * narrow)) / (at.sine * at.sine);
  return true;
}

/// Length of the shorter side of the span of a face that a place lies beside.
double EdgeTies::narrowest(const CadEdge& edge, int use, double x, const PatchPoint& point) const {
  const CadUse& own = edge.uses[std::size_t(use)];
  const SplineSurface& face = faces_.surface(own.piece);
  const bool horizontal = own.side % 2 == 0;
  const SplineSpace &along = horizontal ? face.s : face.t, &across = horizontal ? face.t : face.s;
  const std::size_t beside = own.side == 1 || own.side == 2 ? across.span_count() - 1 : 0;
  const double length = span_width(along, span(edge, use, x)), depth = span_width(across, beside);
  return std::min((horizontal ? point.ds : point.dt).norm() * length,
                  (horizontal ? point.dt : point.ds).norm() * depth);
}

/// Ties the second derivative across the edge in the direction perpendicular to it, as the derivatives of
/// `face` at the place say.
void EdgeTies::tie_bend(const CadEdge& edge, EdgePlace& at, int use, const PatchPoint& face) const {
  const CadUse& own = edge.uses[std::size_t(use)];
  const Vector2 move = move_in(face, at.left);
  const bool horizontal = own.side % 2 == 0;
  at.bend.tie[std::size_t(use)] =
      bend_tie(faces_.surface(own.piece), own.side, growing(edge, use, at.x), at.normal,
               horizontal ? move.x() : move.y(), horizontal ? move.y() : move.x());
}

void EdgeTies::tie_turn(const CadEdge& edge, EdgePlace& at) const {
  at.turn.limit = limits_.angle / at.sine;
  for (int u = 0; u < 2; ++u) {
    const CadUse& use = edge.uses[std::size_t(u)];
    at.turn.tie[std::size_t(u)] = turn_tie(faces_.surface(use.piece), use.side, growing(edge, u, at.x),
                                           at.normal, at.speed[std::size_t(u)]);
    at.turn.weight[std::size_t(u)] = at.width * share(use);
    at.turn.free[std::size_t(u)] = faces_.free(use.piece);
  }
}

void EdgeTies::retie(Index number) {
  const CadEdge& edge = edges_.edges()[number];
  for (EdgePlace& at : places_[number]) {
    for (std::size_t u = 0; u < 2; ++u) {
      const double has = at.speed[u] * at.turn.tie[u].sum(faces_.surface(edge.uses[u].piece)).dot(at.left);
      // A face that is far off for lack of knots tells little about its speed.
      const double ratio = has / at.speed[u];
      at.speed[u] *= std::clamp(ratio, 0.3, 3.0);
      if (!bends()) continue;
      const CadUse& use = edge.uses[u];
      const Vector2 place = (*task_.pieces)[use.piece].parameter(use.side, on_side(edge, int(u), at.x));
      const PatchPoint face = SplineEvaluator(faces_.surface(use.piece)).at(place.x(), place.y());
      // The same holds for its lean against the edge, which has to stay near the surface's.
      const Vector3 over = use.side % 2 == 0 ? face.dt : face.ds;
      const double sine = std::abs(over.dot(at.left)) / over.norm();
      if (has_normal(face) && ratio > 0.3 && ratio < 3 && sine > 0.5 * straight_sine * at.sine)
        tie_bend(edge, at, int(u), face);
    }
    tie_turn(edge, at);
  }
}

void EdgeTies::compare(Index number) {
  const CadEdge& edge = edges_.edges()[number];
  for (EdgePlace& at : places_[number]) {
    std::array<double, 2> angle{};
    for (std::size_t u = 0; u < 2; ++u) {
      const Vector3 across = at.turn.tie[u].sum(faces_.surface(edge.uses[u].piece));
      at.turn.has[u] = across.dot(at.normal);
      // More knots along the edge do not help a face whose derivative across it is very short, or points
      // back.
      angle[u] = at.turn.has[u] / std::clamp(across.dot(at.left), 0.5, 2.0);
    }
    at.jump = std::abs(angle[0] - angle[1]);
    if (!bends()) continue;
    for (std::size_t u = 0; u < 2; ++u)
      at.bend.has[u] = at.bend.tie[u].of(faces_.surface(edge.uses[u].piece));
    at.bend_jump = std::abs(at.bend.has[0] - at.bend.has[1]) / at.bend.limit;
  }
}

double EdgeTies::worst(Index edge) const {
  double out = 0;
  for (const EdgePlace& at : places_[edge]) out = std::max(out, miss(at));
  return out;
}

double EdgeTies::worst_bend(Index edge) const {
  double out = 0;
  for (const EdgePlace& at : places_[edge]) out = std::max(out, bend_miss(at));
  return out;
}

/// Calls visit(place, number of the face's use) in a fixed order.
template <class Visit>
void EdgeTies::for_places(Index face, const Visit& visit) const {
  for (int side = 0; side < 4; ++side)
    for (const Index e : edges_.sides(face)[std::size_t(side)]) {
      const CadEdge& edge = edges_.edges()[e];
      const std::size_t u = edge.uses[0].piece == face && edge.uses[0].side == side ? 0 : 1;
      for (const EdgePlace& at : places_[e]) visit(at, u);
    }
}

void EdgeTies::agreed(Index edge, std::vector<Agreed*>& out) {
  for (EdgePlace& at : places_[edge]) {
    out.push_back(&at.turn);
    if (bends()) out.push_back(&at.bend);
  }
}

std::vector<FaceTie> EdgeTies::ties(Index face) const {
  std::vector<FaceTie> out;
  for_places(face, [&](const EdgePlace& at, std::size_t u) {
    const Agreed& turn = at.turn;
    out.push_back({turn.tie[u], tie_share * tie_share * turn.weight[u] / (turn.limit * turn.limit),
                   (at.across[u] - at.across[u].dot(at.normal) * at.normal) / at.speed[u],
                   slope_share * slope_share, turn.wanted});
    if (!bends()) return;
    const Agreed& bend = at.bend;
    out.push_back({bend.tie[u], tie_share * tie_share * bend.weight[u] / (bend.limit * bend.limit),
                   Vector3::Zero(), 0, bend.wanted});
  });
  return out;
}

std::vector<double> EdgeTies::wanted(Index face) const {
  std::vector<double> out;
  for_places(face, [&](const EdgePlace& at, std::size_t) {
    out.push_back(at.turn.wanted);
    if (bends()) out.push_back(at.bend.wanted);
  });
  return out;
}

}  // namespace hariko
