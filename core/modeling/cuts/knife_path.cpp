#include "core/modeling/cuts/knife_path.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <utility>

#include "core/modeling/operations/face_geometry.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {
namespace {

/// Fraction of an edge's length within which a crossing is moved to the end: a cut beside a vertex would
/// leave an unwanted sliver.
constexpr double vertex_share = 1e-3;

/// A vertex or an edge that the plane crosses.
struct Crossing {
  Index vertex = no_index, edge = no_index;
  friend auto operator<=>(const Crossing&, const Crossing&) = default;
};

/// Entry of the shortest-path search: length so far, and the previous crossing.
struct Reached {
  double length = 0;
  Crossing before;
  Vector3 point = Vector3::Zero();
  double share = 0;  ///< for crossings of edges, from the end with the smaller id
};

class PlaneWalk {
 public:
  PlaneWalk(const Polyhedron& polyhedron, const Vector3& through, const Vector3& normal)
      : polyhedron_(polyhedron), mesh_(polyhedron.topology()), through_(through), normal_(normal) {}

  /// Returns the crossings from one to the other, both included; empty when no path exists.
  std::vector<std::pair<Crossing, double>> find(const Crossing& from, const Crossing& to,
                                                const Vector3& end) {
    using Entry = std::pair<double, Crossing>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    reached_[from] = {0, from, through_, 0};
    queue.push({0, from});
    while (!queue.empty()) {
      const double length = queue.top().first;
      const Crossing at = queue.top().second;
      queue.pop();
      if (at == to) return way_to(to, from);
      const Reached here = reached_.at(at);
      if (length > here.length) continue;
      const auto offer = [&](const Crossing& next, const Vector3& point, double share) {
        if (next == at) return;
        const double way = length + (point - here.point).norm();
        const auto known = reached_.find(next);
        if (known != reached_.end() && known->second.length <= way) return;
        reached_[next] = {way, at, point, share};
        queue.push({way, next});
      };
      for (const Index f : faces_at(at)) {
        if (lies_on(to, f)) offer(to, end, 0);
        for (Index h = mesh_.face_begin(f); h < mesh_.face_end(f); ++h) cross(h, from, offer);
      }
    }
    return {};
  }

 private:
  double height(Index v) const { return normal_.dot(polyhedron_.position(v) - through_); }

  /// Offers the crossing of the plane with a side: inside it, or at one of its ends.
  template <class Offer>
  void cross(Index h, const Crossing& from, const Offer& offer) const {
    const Index a = mesh_.origin(h), b = mesh_.target(h);
    if (from.edge == mesh_.edge(h)) return;  // the cut begins on this edge
    const double ha = height(a), hb = height(b);
    if ((ha > 0 && hb > 0) || (ha < 0 && hb < 0)) return;
    const double span = std::abs(hb - ha);
    if (!(span > 0)) {
      offer({a, no_index}, polyhedron_.position(a), 0);
      return offer({b, no_index}, polyhedron_.position(b), 0);
    }
    const double share = std::abs(ha) / span;
    if (share < vertex_share) return offer({a, no_index}, polyhedron_.position(a), 0);
    if (share > 1 - vertex_share) return offer({b, no_index}, polyhedron_.position(b), 0);
    const Vector3 point = (1 - share) * polyhedron_.position(a) + share * polyhedron_.position(b);
    offer({no_index, mesh_.edge(h)}, point, a < b ? share : 1 - share);
  }

  std::vector<Index> faces_at(const Crossing& crossing) const {
    std::vector<Index> out;
    if (crossing.edge != no_index) {
      const Index h = mesh_.half_edge_of_edge(crossing.edge);
      out.push_back(mesh_.face(h));
      if (mesh_.twin(h) != no_index) out.push_back(mesh_.face(mesh_.twin(h)));
      return out;
    }
    for (const Index h : mesh_.fan_corners(crossing.vertex)) out.push_back(mesh_.face(h));
    return out;
  }

  bool lies_on(const Crossing& crossing, Index face) const {
    for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h)
      if (mesh_.edge(h) == crossing.edge || mesh_.origin(h) == crossing.vertex) return true;
    return false;
  }

  std::vector<std::pair<Crossing, double>> way_to(const Crossing& to, const Crossing& from) const {
    std::vector<std::pair<Crossing, double>> out;
    for (Crossing at = to; at != from; at = reached_.at(at).before)
      out.emplace_back(at, reached_.at(at).share);
    out.emplace_back(from, 0);
    std::reverse(out.begin(), out.end());
    return out;
  }

  const Polyhedron& polyhedron_;
  const HalfEdgeMesh& mesh_;
  Vector3 through_, normal_;
  std::map<Crossing, Reached> reached_;
};

Result<Crossing> crossing_of(const Polyhedron& polyhedron, const CutPoint& point) {
  if (const auto* vertex = std::get_if<VertexId>(&point)) {
    const auto known = selected(polyhedron, std::span<const VertexId>(vertex, 1), "Click a vertex.");
    if (!known) return known.error();
    return Crossing{(*known)[0], no_index};
  }
  const auto& on = std::get<EdgePoint>(point);
  const auto known = selected(polyhedron, std::span<const EdgeId>(&on.edge, 1), "Click an edge.");
  if (!known) return known.error();
  if (!(on.share > 0 && on.share < 1))
    return make_error(e_bad_amount, "The point does not lie inside the edge.",
                      "Cut through the edge or an end.", element_of(on.edge));
  return Crossing{no_index, (*known)[0]};
}

}  // namespace

Vector3 position_of(const Polyhedron& polyhedron, const CutPoint& point) {
  if (const auto* vertex = std::get_if<VertexId>(&point))
    return polyhedron.position(polyhedron.find(*vertex));
  const auto& on = std::get<EdgePoint>(point);
  return (1 - on.share) * polyhedron.position(polyhedron.find(on.edge.low)) +
         on.share * polyhedron.position(polyhedron.find(on.edge.high));
}

Result<std::vector<CutPoint>> knife_path(const Polyhedron& polyhedron, const CutPoint& from,
                                         const CutPoint& to, const Vector3& normal) {
  const auto first = crossing_of(polyhedron, from), last = crossing_of(polyhedron, to);
  if (!first) return first.error();
  if (!last) return last.error();
  const Vector3 across = direction_of(normal);
  if (!across.allFinite() || across.isZero(0))
    return make_error(e_bad_amount, "The plane of the cut has no direction.", "Click another point.");
  if (*first == *last) return std::vector<CutPoint>();
  PlaneWalk walk(polyhedron, position_of(polyhedron, from), across);
  const auto way = walk.find(*first, *last, position_of(polyhedron, to));
  if (way.empty())
    return make_error(e_wrong_selection, "No straight cut leads from the last point to this one.",
                      "Click a point on a face that the cut reaches.",
                      last->vertex != no_index ? element_of(polyhedron.vertex_id(last->vertex))
                                               : element_of(polyhedron.edge_id(last->edge)));
  std::vector<CutPoint> out;
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    const auto& [crossing, share] = way[i];
    if (crossing.vertex != no_index)
      out.emplace_back(polyhedron.vertex_id(crossing.vertex));
    else
      out.emplace_back(EdgePoint{polyhedron.edge_id(crossing.edge), share});
  }
  return out;
}

}  // namespace hariko
