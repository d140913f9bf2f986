#include "core/modeling/operations/bevel_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/operations/amount.hpp"
#include "core/modeling/operations/face_geometry.hpp"
#include "core/modeling/operations/short_edges.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {
namespace {

/// One edge at a vertex. In an open fan the last edge has no outgoing half-edge here.
struct FanEdge {
  Index edge;
  Index other;  ///< vertex at its far end
  bool bevelled;
};

/// Edges at a vertex, counter-clockwise; corner k lies between edges k and k + 1.
struct Fan {
  std::vector<FanEdge> edges;
  std::vector<Index> corners;  ///< half-edges
  bool closed;
};

/// Points that replace a vertex in one face: the boundary of the face arrives at `end` and leaves from
/// `start`, usually the same point.
struct CornerPoints {
  Index start, end;
};

class EdgeBevel {
 public:
  EdgeBevel(const PolyhedronSource& source, std::vector<char> bevelled)
      : source_(source),
        polyhedron_(source.polyhedron),
        mesh_(polyhedron_.topology()),
        bevelled_(std::move(bevelled)),
        corners_(mesh_.half_edge_count()),
        vertex_polygons_(mesh_.vertex_count()) {
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      points_.push_back({{polyhedron_.position(v), zero()}, v});
    for (Index h = 0; h < mesh_.half_edge_count(); ++h) corners_[h] = {mesh_.origin(h), mesh_.origin(h)};
    for (Index v = 0; v < mesh_.vertex_count(); ++v) resolve_vertex(v);
  }

  /// Returns an edge whose band has no width at either end; no_index when there is none.
  Index pointless_edge() const {
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      if (!bevelled_[e]) continue;
      const Index h = mesh_.half_edge_of_edge(e), t = mesh_.twin(h);
      if (left_at_origin(h) == left_at_target(t) && left_at_target(h) == left_at_origin(t)) return e;
    }
    return no_index;
  }

  /// Returns the width at which the first edge of a face shrinks to nothing.
  double limit() const {
    double limit = std::numeric_limits<double>::infinity();
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      const std::vector<Index> outline = outline_of(f);
      for (std::size_t i = 0; i < outline.size(); ++i)
        limit = std::min(limit, collapse_amount(points_[outline[i]].slide,
                                                points_[outline[(i + 1) % outline.size()]].slide));
    }
    return limit;
  }

  Result<EditResult> run(double width) {
    MeshEditor draft(source_);
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const Point& point = points_[p];
      if (p < mesh_.vertex_count()) {
        ids_.push_back(polyhedron_.vertex_id(point.vertex));
      } else {
        ids_.push_back(draft.add_vertex(point.slide.position + width * point.slide.rate));
        draft.inherit(polyhedron_.vertex_id(point.vertex), ids_.back());
      }
    }
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      std::vector<VertexId> outline = named(outline_of(f));
      const auto old = draft.face(polyhedron_.face_id(f));
      if (!std::equal(outline.begin(), outline.end(), old.begin(), old.end()))
        draft.set_face(polyhedron_.face_id(f), std::move(outline));
    }
    carry_edges(draft);
    ElementSet selection;
    for (Index e = 0; e < mesh_.edge_count(); ++e)
      if (bevelled_[e]) selection.faces.insert(add_band(draft, e));
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (!vertex_polygons_[v].empty()) selection.faces.insert(draft.add_face(named(vertex_polygons_[v])));
    Result<PolyhedronSource> result = std::move(draft).finish();
    if (!result) return result.error();
    tighten_short_edges(result.value(), source_);
    if (const FaceId face = first_turned_face(polyhedron_, result->polyhedron); face != FaceId{})
      return too_wide(element_of(face));
    return EditResult{std::move(result).value(), std::move(selection)};
  }

  static Message too_wide(Element element) {
    return make_error(e_bad_amount, "The bevel is too wide: a face beside it would shrink or turn over.",
                      "Use a smaller width.", element);
  }

 private:
  /// Point of the result. The first points are the old vertices; the others are new and replace `vertex`.
  struct Point {
    Slide slide;
    Index vertex;
  };

  static Vector3 zero() { return Vector3::Zero(); }

  Fan fan_of(Index v) const {
    Fan fan;
    fan.closed = !mesh_.is_border_vertex(v);
    for (const Index h : mesh_.fan_corners(v)) {
      fan.edges.push_back({mesh_.edge(h), mesh_.target(h), bevelled_[mesh_.edge(h)] != 0});
      fan.corners.push_back(h);
      const Index last = mesh_.previous(h);
      if (mesh_.rotate(h) == no_index) fan.edges.push_back({mesh_.edge(last), mesh_.origin(last), false});
    }
    return fan;
  }

  Index add_point(Index v, const Vector3& rate) {
    points_.push_back({{polyhedron_.position(v), rate}, v});
    return static_cast<Index>(points_.size() - 1);
  }

  Vector3 along(Index v, const FanEdge& edge) const {
    return direction_of(polyhedron_.position(edge.other) - polyhedron_.position(v));
  }

  /// Length by which a point slides along `direction` to be 1 away from a line with the normal `away`; at
  /// most 5, because it is unbounded for nearly parallel lines.
  static double slide_length(const Vector3& direction, const Vector3& away) {
    return away.isZero(0) ? 1.0 : 1 / std::max(direction.dot(away), 0.2);
  }

  void resolve_vertex(Index v) {
    if (mesh_.outgoing(v) == no_index) return;
    const Fan fan = fan_of(v);
    std::vector<std::size_t> bands;
    for (std::size_t k = 0; k < fan.edges.size(); ++k)
      if (fan.edges[k].bevelled) bands.push_back(k);
    if (bands.empty()) return;
    if (fan.closed && bands.size() == 1)
      end_band(v, fan, bands[0]);
    else
      join_bands(v, fan, bands);
  }

  /// Lets corners first .. last of the fan (indices may exceed the size of a closed fan) meet in one point.
  void set_corners(const Fan& fan, std::size_t first, std::size_t last, Index point) {
    for (std::size_t k = first; k < last; ++k) corners_[fan.corners[k % fan.corners.size()]] = {point, point};
  }

  /// Inward direction in the face to the left of fan edge k; `right_of`: in the face to its right.
  Vector3 left_of(const Fan& fan, std::size_t k) const {
    return inward_direction(polyhedron_, fan.corners[k % fan.corners.size()]);
  }
  Vector3 right_of(const Fan& fan, std::size_t k) const {
    const std::size_t count = fan.corners.size();
    return inward_direction(polyhedron_, mesh_.previous(fan.corners[(k + count - 1) % count]));
  }

  /// Replaces the vertex: each sector between two bands, or between a band and the border, gets one point.
  void join_bands(Index v, const Fan& fan, const std::vector<std::size_t>& bands) {
    std::vector<Index> polygon;
    const std::size_t count = fan.edges.size();
    if (!fan.closed) {
      const Vector3 border = along(v, fan.edges[0]);
      polygon.push_back(add_point(v, border * slide_length(border, right_of(fan, bands[0]))));
      set_corners(fan, 0, bands[0], polygon.back());
    }
    for (std::size_t i = 0; i + (fan.closed ? 0 : 1) < bands.size(); ++i) {
      const std::size_t from = bands[i], to = i + 1 < bands.size() ? bands[i + 1] : bands[0] + count;
      const Vector3 left = left_of(fan, from), right = right_of(fan, to);
      Vector3 rate = miter(left, right);
      if (to - from == 2) {
        const Vector3 guide = along(v, fan.edges[(from + 1) % count]);
        if (!guide.isZero(0)) rate = guide * (slide_length(guide, left) / 2 + slide_length(guide, right) / 2);
      }
      polygon.push_back(add_point(v, rate));
      set_corners(fan, from, to, polygon.back());
    }
    if (!fan.closed) {
      const Vector3 border = along(v, fan.edges.back());
      polygon.push_back(add_point(v, border * slide_length(border, left_of(fan, bands.back()))));
      set_corners(fan, bands.back(), count - 1, polygon.back());
    }
    if (polygon.size() >= 3) vertex_polygons_[v] = std::move(polygon);
  }

  /// Ends the only band at an inner vertex there, by cutting all other edges; with more than two of them a
  /// face closes the gap.
  void end_band(Index v, const Fan& fan, std::size_t band) {
    const std::size_t count = fan.edges.size();
    if (count == 2) return;  // the band runs into the vertex
    const auto edge = [&](std::size_t k) -> const FanEdge& { return fan.edges[(band + k) % count]; };
    const auto corner = [&](std::size_t k) -> CornerPoints& {
      return corners_[fan.corners[(band + k) % count]];
    };
    std::vector<Index> cuts;  // on the edges after the band, counter-clockwise
    for (std::size_t k = 1; k < count; ++k) {
      const Vector3 guide = along(v, edge(k));
      double length = 1;
      if (k == 1) length = slide_length(guide, left_of(fan, band));
      if (k + 1 == count) length = slide_length(guide, right_of(fan, band));
      cuts.push_back(add_point(v, guide * length));
    }
    corner(0) = {cuts.front(), cuts.front()};
    corner(count - 1) = {cuts.back(), cuts.back()};
    for (std::size_t k = 1; k + 1 < count; ++k) corner(k) = {cuts[k - 1], cuts[k]};
    if (count == 3) return;
    vertex_polygons_[v] = cuts;
    const auto creased = [&](std::size_t k) {
      return source_.shaping->crease.contains(polyhedron_.edge_id(edge(k).edge));
    };
    bool carries_on = false;
    for (std::size_t k = 2; k + 2 <= count; ++k) carries_on = carries_on || creased(k);
    if (creased(0) && carries_on)
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) crease_ends_.emplace_back(cuts[i], cuts[i + 1]);
  }

  std::vector<Index> outline_of(Index f) const {
    std::vector<Index> outline;
    for (Index h = mesh_.face_begin(f); h < mesh_.face_end(f); ++h) {
      const CornerPoints& corner = corners_[h];
      outline.push_back(corner.end);
      if (corner.start != corner.end) outline.push_back(corner.start);
    }
    return outline;
  }

  std::vector<VertexId> named(const std::vector<Index>& points) const {
    std::vector<VertexId> out;
    for (const Index p : points) out.push_back(ids_[p]);
    return out;
  }

  /// End points of the half-edge in its own face.
  Index left_at_origin(Index h) const { return corners_[h].start; }
  Index left_at_target(Index h) const { return corners_[mesh_.next(h)].end; }

  void carry_edges(MeshEditor& draft) const {
    for (Index h = 0; h < mesh_.half_edge_count(); ++h) {
      const EdgeId from = polyhedron_.edge_id(mesh_.edge(h));
      const Index a = left_at_origin(h), b = left_at_target(h);
      if (const EdgeId to = EdgeId::of(ids_[a], ids_[b]); to != from) draft.inherit(from, to);
    }
    for (const auto& [a, b] : crease_ends_) draft.shaping().crease.set(EdgeId::of(ids_[a], ids_[b]), true);
  }

  FaceId add_band(MeshEditor& draft, Index e) const {
    const Index h = mesh_.half_edge_of_edge(e), t = mesh_.twin(h);
    std::vector<Index> corners{left_at_target(h), left_at_origin(h)};
    if (left_at_target(t) != corners.back()) corners.push_back(left_at_target(t));
    if (left_at_origin(t) != corners.front()) corners.push_back(left_at_origin(t));
    return draft.add_face(named(corners));
  }

  const PolyhedronSource& source_;
  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  std::vector<char> bevelled_;
  std::vector<CornerPoints> corners_;
  std::vector<Point> points_;
  std::vector<std::vector<Index>> vertex_polygons_;
  std::vector<std::pair<Index, Index>> crease_ends_;  ///< sides of end faces through which a crease continues
  std::vector<VertexId> ids_;
};

Result<EdgeBevel> prepare(const PolyhedronSource& source, std::span<const EdgeId> edges) {
  const Polyhedron& polyhedron = source.polyhedron;
  const auto chosen = selected(polyhedron, edges, "Select the edges to bevel.");
  if (!chosen) return chosen.error();
  std::vector<char> bevelled(polyhedron.edge_count(), 0);
  bool any = false;
  for (const Index e : *chosen) {
    if (polyhedron.topology().is_border_edge(e)) continue;
    bevelled[e] = 1;
    any = true;
  }
  if (!any)
    return make_error(e_wrong_selection, "Open edges have a face on one side only and cannot be bevelled.",
                      "Select edges between two faces.", element_of(polyhedron.edge_id(chosen->front())));
  EdgeBevel bevel(source, std::move(bevelled));
  if (const Index e = bevel.pointless_edge(); e != no_index)
    return make_error(e_wrong_selection,
                      "Both ends of the edge lie within a line of edges: its band has no width.",
                      "Select the edges that it continues as well.", element_of(polyhedron.edge_id(e)));
  return bevel;
}

}  // namespace

Result<double> largest_edge_bevel(const PolyhedronSource& source, std::span<const EdgeId> edges) {
  const auto bevel = prepare(source, edges);
  if (!bevel) return bevel.error();
  return bevel->limit();
}

Result<EditResult> bevel_edges(const PolyhedronSource& source, std::span<const EdgeId> edges, double width) {
  if (const auto positive = detail::check_positive(width); !positive) return positive.error();
  auto bevel = prepare(source, edges);
  if (!bevel) return bevel.error();
  if (!(width < bevel->limit())) return EdgeBevel::too_wide({});
  return bevel.value().run(width);
}

}  // namespace hariko
