#include "core/modeling/surfacing/surface_form.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/solvers/dense_solver.hpp"
#include "core/document/edits/edit_elements.hpp"
#include "core/geometry/curve_places.hpp"
#include "core/modeling/surfacing/kept_tangents.hpp"
#include "core/modeling/surfacing/surface_input.hpp"
#include "core/network/vertex_frames.hpp"

namespace hariko {
namespace {

using Bezier = std::array<Vector3, 4>;

/// Number of points on a surface curve to which its cubic is fitted.
constexpr int fitted_points = 16;

/// Smallest relative difference of areas that is worth keeping.
constexpr double least_difference = 1e-3;

Vector3 bezier_point(const Bezier& b, double t) {
  const double s = 1 - t;
  return s * s * s * b[0] + 3 * s * s * t * b[1] + 3 * s * t * t * b[2] + t * t * t * b[3];
}

/// A third of the derivative of the curve at t.
Vector3 bezier_tangent(const Bezier& b, double t) {
  const double s = 1 - t;
  return s * s * (b[1] - b[0]) + 2 * s * t * (b[2] - b[1]) + t * t * (b[3] - b[2]);
}

/// Coefficients a, b with point = a p + b q in the least-squares sense; (-1, -1) where p and q are parallel.
Vector2 plane_shares(const Vector3& point, const Vector3& p, const Vector3& q) {
  const double pp = p.squaredNorm(), pq = p.dot(q), qq = q.squaredNorm(), det = pp * qq - pq * pq;
  if (!(det > 1e-24 * pp * qq)) return {-1, -1};
  const double a = p.dot(point), b = q.dot(point);
  return Vector2(qq * a - pq * b, pp * b - pq * a) / det;
}

Vector2 plane_shares(const Vector2& point, const Vector2& p, const Vector2& q) {
  const double det = p.x() * q.y() - p.y() * q.x();
  return Vector2(point.x() * q.y() - point.y() * q.x(), p.x() * point.y() - p.y() * point.x()) / det;
}

/// Two unit vectors perpendicular to a normal and to each other.
std::array<Vector3, 2> plane_basis(const Vector3& normal) {
  const Vector3 first = normal.unitOrthogonal();
  return {first, normal.cross(first)};
}

/// End tangents, within given planes, of the cubic through the first and the last point that approximates the
/// points in the least-squares sense, parametrised by chord length. Thirds of the chord where a normal
/// vanishes.
std::pair<Vector3, Vector3> fitted_cubic(const std::vector<Vector3>& points, const Vector3& first_normal,
                                         const Vector3& last_normal) {
  const std::vector<double> along = lengths_along(points);
  const Vector3 straight = (points.back() - points.front()) / 3;
  if (!(along.back() > 0) || first_normal.isZero(0) || last_normal.isZero(0)) return {straight, -straight};
  const auto at_first = plane_basis(first_normal), at_last = plane_basis(last_normal);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4, 4);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(4);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double t = along[i] / along.back(), s = 1 - t, b1 = 3 * s * s * t, b2 = 3 * s * t * t;
    const std::array<Vector3, 4> column{b1 * at_first[0], b1 * at_first[1], b2 * at_last[0], b2 * at_last[1]};
    const Vector3 rest = points[i] - (s * s * s + b1) * points.front() - (t * t * t + b2) * points.back();
    for (int a = 0; a < 4; ++a) {
      right[a] += column[std::size_t(a)].dot(rest);
      for (int b = 0; b < 4; ++b) matrix(a, b) += column[std::size_t(a)].dot(column[std::size_t(b)]);
    }
  }
  const Eigen::VectorXd x = solve_symmetric(matrix, right);
  return {x[0] * at_first[0] + x[1] * at_first[1], x[2] * at_last[0] + x[3] * at_last[1]};
}

double area_of(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index face) {
  double out = 0;
  for (Index h = mesh.face_begin(face); h < mesh.face_end(face); ++h) out += charts.area[h];
  return out;
}

}  // namespace

Result<SurfaceForm> SurfaceForm::of(const PolyhedronSource& source) {
  auto input = surface_input(source);
  if (!input) return input.error();
  PolyhedronSurfacer surfacer;
  auto surface = surfacer.rebuild(*input);
  if (!surface) return surface.error();
  auto frames = build_vertex_frames(input->polyhedron, input->shaping, {Frames::metric});
  if (!frames) return frames.error();
  FaceCharts charts = std::move(frames.value().charts);
  return SurfaceForm(source, std::move(input).value(), std::move(surface).value(), std::move(charts));
}

SurfaceForm::SurfaceForm(const PolyhedronSource& source, PolyhedronSurfaceInput input,
                         PolyhedronSurface surface, FaceCharts charts)
    : source_(source), input_(std::move(input)), surface_(std::move(surface)), charts_(std::move(charts)) {
  for (Index f = 0; f < input_.polyhedron.face_count(); ++f) {
    const FaceId id = input_.polyhedron.face_id(f);
    if (input_.aliases && input_.aliases->is_copy(id)) continue;
    parts_[input_.aliases ? input_.aliases->original(id) : id].push_back(f);
  }
}

std::optional<Bezier> SurfaceForm::curve(EdgeId edge) const {
  const Polyhedron& polyhedron = input_.polyhedron;
  const Index e = polyhedron.find(edge);
  if (e == no_index) return std::nullopt;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const Index h = mesh.half_edge_of_edge(e), a = mesh.origin(h), b = mesh.target(h);
  const Vector3 shift = input_.origin - source_.origin;
  const Vector3 &start = surface_.network->start[h], &end = surface_.network->end[h];
  const Vector3 first = polyhedron.position(a) + shift, last = polyhedron.position(b) + shift;
  Bezier out{first, first + start, last + end, last};
  if (polyhedron.vertex_id(a) != edge.low) std::reverse(out.begin(), out.end());
  return out;
}

SurfaceForm::Sight SurfaceForm::sight(VertexId id) const {
  const HalfEdgeMesh& mesh = input_.polyhedron.topology();
  Sight out;
  out.vertex = input_.polyhedron.find(id);
  if (out.vertex == no_index) return out;
  for (const Index h : mesh.fan_corners(out.vertex)) out.spots.push_back({mesh.face(h), charts_.corner[h]});
  return out;
}

SurfaceForm::Sight SurfaceForm::sight(const RefinedPoint& place) const {
  const Polyhedron& polyhedron = input_.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  Sight out;
  if (const auto* on = std::get_if<EdgePoint>(&place)) {
    const Index e = polyhedron.find(on->edge);
    if (e == no_index) {  // the edge's faces were merged
      const Sight low = sight(on->edge.low), high = sight(on->edge.high);
      for (const Spot& a : low.spots)
        for (const Spot& b : high.spots)
          if (a.face == b.face && out.spots.empty())
            out.spots.push_back({a.face, (1 - on->share) * a.chart + on->share * b.chart});
      return out;
    }
    out.on = *on;
    for (Index h = mesh.half_edge_of_edge(e); h != no_index;
         h = h == mesh.half_edge_of_edge(e) ? mesh.twin(h) : no_index) {
      const bool forward = polyhedron.vertex_id(mesh.origin(h)) == on->edge.low;
      const double t = forward ? on->share : 1 - on->share;
      out.spots.push_back({mesh.face(h), (1 - t) * charts_.corner[h] + t * charts_.corner[mesh.next(h)]});
    }
    return out;
  }
  const auto& in = std::get<FacePoint>(place);
  const Vector3 position = in.position + source_.origin - input_.origin;
  std::optional<Spot> best;
  double best_distance = 0;
  const FaceId whole = input_.aliases ? input_.aliases->merged.get_or(in.face, in.face) : in.face;
  const auto found = parts_.find(whole);
  if (found == parts_.end()) return out;
  for (const Index f : found->second) {
    const auto spot = spot_in_face(f, position);
    if (!spot) continue;
    const double distance = (point(*spot) - position).norm();
    if (best && !(distance < best_distance)) continue;
    best = spot;
    best_distance = distance;
  }
  if (best) out.spots.push_back(*best);
  return out;
}

std::optional<SurfaceForm::Spot> SurfaceForm::spot_in_face(Index face, const Vector3& position) const {
  const Polyhedron& polyhedron = input_.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  Vector3 middle = Vector3::Zero();
  double round = 0;
  for (Index h = mesh.face_begin(face); h < mesh.face_end(face); ++h) {
    const Vector3 &a = polyhedron.position(mesh.origin(h)), &b = polyhedron.position(mesh.target(h));
    const double length = (b - a).norm();
    middle += length * (a + b) / 2;
    round += length;
  }
  if (!(round > 0)) return std::nullopt;
  middle /= round;
  std::optional<Spot> out;
  double least = 0;
  for (Index h = mesh.face_begin(face); h < mesh.face_end(face); ++h) {
    const Vector2 found =
        plane_shares(Vector3(position - middle), Vector3(polyhedron.position(mesh.origin(h)) - middle),
                     Vector3(polyhedron.position(mesh.target(h)) - middle));
    if (out && !(found.minCoeff() > least)) continue;
    least = found.minCoeff();
    const Vector2 inside = found.cwiseMax(0.0) / std::max(1.0, found.cwiseMax(0.0).sum());
    out = Spot{face, inside.x() * charts_.corner[h] + inside.y() * charts_.corner[mesh.next(h)]};
  }
  return out;
}

std::pair<Index, Vector2> SurfaceForm::parameter(const Spot& spot) const {
  const HalfEdgeMesh& mesh = input_.polyhedron.topology();
  Index patch = mesh.face_begin(spot.face);
  Vector2 best(-1, -1);
  for (Index h = patch; h < mesh.face_end(spot.face); ++h) {
    const Vector2 found = plane_shares(spot.chart, charts_.corner[h], charts_.corner[mesh.next(h)]);
    if (h != patch && !(found.minCoeff() > best.minCoeff())) continue;
    patch = h;
    best = found;
  }
  best = best.cwiseMax(0.0);
  return {patch, best / std::max(1.0, best.sum())};
}

Vector3 SurfaceForm::point(const Spot& spot) const {
  const auto [patch, at] = parameter(spot);
  return surface_.surface.patches().evaluate(patch, at, Order::first).position;
}

std::optional<Vector3> SurfaceForm::point(const Sight& sight) const {
  const Vector3 shift = source_.origin - input_.origin;
  if (sight.on)
    if (const auto own = curve(sight.on->edge)) return bezier_point(*own, sight.on->share) + shift;
  if (sight.spots.empty()) return std::nullopt;
  return point(sight.spots.front());
}

std::optional<std::pair<Vector3, Vector3>> SurfaceForm::tangents_along_edge(const Sight& a,
                                                                            const Sight& b) const {
  const Polyhedron& polyhedron = input_.polyhedron;
  if (a.vertex != no_index && b.vertex != no_index) {
    const auto own = curve(EdgeId::of(polyhedron.vertex_id(a.vertex), polyhedron.vertex_id(b.vertex)));
    if (!own) return std::nullopt;
    const bool forward = polyhedron.vertex_id(a.vertex) < polyhedron.vertex_id(b.vertex);
    const Vector3 low = bezier_tangent(*own, 0), high = -bezier_tangent(*own, 1);
    return forward ? std::pair(low, high) : std::pair(high, low);
  }
  if (!a.on && !b.on) return std::nullopt;
  const EdgeId edge = a.on ? a.on->edge : b.on->edge;
  const auto along = [&](const Sight& sight) -> std::optional<double> {
    if (sight.on && sight.on->edge == edge) return sight.on->share;
    if (sight.vertex == no_index) return std::nullopt;
    const VertexId id = polyhedron.vertex_id(sight.vertex);
    return id == edge.low ? std::optional(0.0) : id == edge.high ? std::optional(1.0) : std::nullopt;
  };
  const auto from = along(a), to = along(b);
  const auto own = curve(edge);
  if (!from || !to || !own) return std::nullopt;
  return std::pair<Vector3, Vector3>((*to - *from) * bezier_tangent(*own, *from),
                                     (*from - *to) * bezier_tangent(*own, *to));
}

std::vector<Vector3> SurfaceForm::points_across(const Spot& a, const Spot& b) const {
  std::vector<Vector3> points;
  for (int i = 0; i <= fitted_points; ++i) {
    const double t = double(i) / fitted_points;
    points.push_back(point({a.face, (1 - t) * a.chart + t * b.chart}));
  }
  return points;
}

std::vector<Vector3> SurfaceForm::path(const RefinedPoint& from, const RefinedPoint& to) const {
  const Sight a = sight(from), b = sight(to);
  for (const Spot& begin : a.spots)
    for (const Spot& end : b.spots) {
      if (begin.face != end.face) continue;
      std::vector<Vector3> points = points_across(begin, end);
      for (Vector3& position : points) position += input_.origin - source_.origin;
      return points;
    }
  return {};
}

std::pair<Vector3, Vector3> SurfaceForm::tangents_across(const Spot& a, const Spot& b) const {
  const std::vector<Vector3> points = points_across(a, b);
  const auto normal = [&](const Spot& spot) {
    const auto [patch, at] = parameter(spot);
    return surface_.surface.normal(patch, at);
  };
  return fitted_cubic(points, normal(a), normal(b));
}

std::optional<std::pair<Vector3, Vector3>> SurfaceForm::tangents(const Sight& a, const Sight& b) const {
  if (auto along = tangents_along_edge(a, b)) return along;
  for (const Spot& from : a.spots)
    for (const Spot& to : b.spots)
      if (from.face == to.face) return tangents_across(from, to);
  return std::nullopt;
}

std::optional<SurfaceForm::ChartedFace> SurfaceForm::charted(const Polyhedron& after, Index face,
                                                             Index corner, const SightOf& sight_of) const {
  std::vector<Sight> sights;
  ChartedFace out;
  for (const Index v : after.topology().face_vertices(face)) {
    if (v == corner) out.number_of_corner = sights.size();
    sights.push_back(sight_of(after.vertex_id(v)));
  }
  const auto whole = common_face(sights);
  if (!whole) return std::nullopt;
  out.whole = *whole;
  for (const Sight& each : sights)
    out.corners.push_back(std::find_if(each.spots.begin(), each.spots.end(), [&](const Spot& spot) {
                            return spot.face == *whole;
                          })->chart);
  return out;
}

Vector3 SurfaceForm::split_direction(const ChartedFace& face) const {
  Vector2 middle = Vector2::Zero();
  double round = 0;
  for (std::size_t j = 0; j < face.corners.size(); ++j) {
    const Vector2 &p = face.corners[j], &q = face.corners[(j + 1) % face.corners.size()];
    middle += (q - p).norm() * (p + q) / 2;
    round += (q - p).norm();
  }
  if (!(round > 0)) return Vector3::Zero();
  const Vector2& corner = face.corners[face.number_of_corner];
  const auto [patch, at] = parameter({face.whole, corner});
  const Vector2 way = plane_shares(Vector2(middle / round - corner), charts_.corner[patch],
                                   charts_.corner[input_.polyhedron.topology().next(patch)]);
  const PatchPoint point = surface_.surface.patches().evaluate(patch, at, Order::first);
  return way.x() * point.ds + way.y() * point.dt;
}

std::optional<std::pair<double, double>> SurfaceForm::parts_of_side(const ChartedFace& face) {
  const std::size_t n = face.corners.size(), at = face.number_of_corner;
  const Vector2& before = face.corners[(at + n - 1) % n];
  const Vector2 side = face.corners[(at + 1) % n] - before, part = face.corners[at] - before;
  const double square = side.squaredNorm(), along = part.dot(side) / square;
  const double across = std::abs(part.x() * side.y() - part.y() * side.x()) / square;
  if (!(square > 0) || !(across < 1e-9) || !(along > 1e-9 && along < 1 - 1e-9)) return std::nullopt;
  return std::pair(along, 1 - along);
}

std::optional<Index> SurfaceForm::common_face(std::span<const Sight> corners) {
  for (const Spot& spot : corners.front().spots) {
    const auto has_face = [&](const Sight& corner) {
      return std::any_of(corner.spots.begin(), corner.spots.end(),
                         [&](const Spot& other) { return other.face == spot.face; });
    };
    if (std::all_of(corners.begin(), corners.end(), has_face)) return spot.face;
  }
  return std::nullopt;
}

double SurfaceForm::counted_area(Index face) const {
  return area_of(input_.polyhedron.topology(), charts_, face) *
         input_.shaping.kept_area.get_or(input_.polyhedron.face_id(face), 1);
}

Result<FlatMap<FaceId, double>> SurfaceForm::kept_areas(const PolyhedronSurfaceInput& after,
                                                        const SightOf& sight_of) const {
  const Polyhedron& polyhedron = after.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto frames = build_vertex_frames(polyhedron, after.shaping, {Frames::metric});
  if (!frames) return frames.error();
  const FaceCharts& charts = frames->charts;
  // Faces that are cut in the preparation have no area of their own: they keep their factors.
  std::set<FaceId> cut;
  if (after.aliases)
    for (const auto& [piece, face] : after.aliases->pieces) cut.insert(face);
  FlatMap<FaceId, double> out;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const FaceId id = polyhedron.face_id(f);
    if (after.aliases && (after.aliases->is_copy(id) || after.aliases->original(id) != id)) continue;
    if (cut.contains(id)) {
      if (const double* factor = source_.shaping->kept_area.find(id)) out.set(id, *factor);
      continue;
    }
    std::vector<Sight> corners;
    for (const Index v : mesh.face_vertices(f)) corners.push_back(sight_of(polyhedron.vertex_id(v)));
    const auto whole = common_face(corners);
    const double area = area_of(mesh, charts, f);
    if (!whole || !(area > 0)) continue;
    const double factor = std::clamp(counted_area(*whole) / area, 1 / max_kept_area, max_kept_area);
    if (std::abs(factor - 1) > least_difference) out.set(id, factor);
  }
  return out;
}

Result<PolyhedronSource> SurfaceForm::keep(PolyhedronSource after, const RefinedPoints& places) const {
  std::map<VertexId, Sight> new_sights;
  std::vector<Index> vertices;
  std::vector<Vector3> positions;
  for (const auto& [id, place] : places) {
    const Index v = after.polyhedron.find(id);
    if (v == no_index) continue;
    Sight found = sight(place);
    if (const auto on = point(found)) {
      vertices.push_back(v);
      positions.push_back(*on + input_.origin - after.origin);
    }
    new_sights.emplace(id, std::move(found));
  }
  auto moved = after.polyhedron.with_positions(vertices, positions);
  if (!moved) return moved.error();
  after.polyhedron = std::move(moved).value();
  if (frames_in(after.mode, after.frames) != Frames::metric) return after;

  Shaping shaping = *after.shaping;
  shaping.form = {};
  shaping.kept_area = {};
  after.shaping = shaping;
  const auto prepared = surface_input(after);
  if (!prepared) return prepared.error();
  const auto sight_of = [&](VertexId id) {
    const auto found = new_sights.find(id);
    return found == new_sights.end() ? sight(id) : found->second;
  };
  const auto was_on_side = [&](VertexId v) {
    const KeptForm* form = source_.shaping->form.find(v);
    return form && std::any_of(form->edges.begin(), form->edges.end(),
                               [](const KeptForm::Edge& edge) { return edge.side > 0; });
  };
  const Polyhedron& finer = prepared->polyhedron;
  const auto corner = [&](VertexId v, FaceId f) {
    return charted(finer, finer.find(f), finer.find(v), sight_of);
  };
  const WantedForm wanted{[&](VertexId a, VertexId b) { return tangents(sight_of(a), sight_of(b)); },
                          [&](VertexId v, FaceId f) {
                            const auto face = corner(v, f);
                            return face ? std::optional(split_direction(*face)) : std::nullopt;
                          },
                          [&](VertexId v, FaceId f) -> std::optional<std::pair<double, double>> {
                            if (!new_sights.contains(v) && !was_on_side(v)) return std::nullopt;
                            const auto face = corner(v, f);
                            return face ? parts_of_side(*face) : std::nullopt;
                          }};
  auto forms = kept_tangents(*prepared, wanted);
  if (!forms) return forms.error();
  for (auto& [id, form] : *forms)
    if (says_something(form)) shaping.form.set(id, std::move(form));
  after.shaping = shaping;
  const auto with_forms = surface_input(after);
  if (!with_forms) return with_forms.error();
  auto areas = kept_areas(*with_forms, sight_of);
  if (!areas) return areas.error();
  shaping.kept_area = std::move(areas).value();
  after.shaping = std::move(shaping);
  return after;
}

Result<std::optional<SurfaceForm>> form_to_keep(const PolyhedronSource& source) {
  if (frames_in(source.mode, source.frames) != Frames::metric) return std::optional<SurfaceForm>();
  auto form = SurfaceForm::of(source);
  if (!form) return form.error();
  return std::optional(std::move(form).value());
}

Result<EditResult> finish_refined(MeshEditor&& draft, ElementSet selection, const SurfaceForm* on) {
  const RefinedPoints places = draft.places();
  auto modeled = std::move(draft).finish(std::move(selection));
  if (!modeled || !on) return modeled;
  auto kept = on->keep(std::move(modeled.value().source), places);
  if (!kept) return kept.error();
  modeled.value().source = std::move(kept).value();
  return modeled;
}

}  // namespace hariko
