#include "core/geometry/convex_hull.hpp"

#include <algorithm>

#include "core/base/assert.hpp"
#include "core/geometry/orientation.hpp"

namespace hariko {
namespace {

/// Four points that span space, far apart; nothing when all points lie in one plane.
std::optional<std::array<Index, 4>> spanning_points(const std::vector<Vector3>& points) {
  if (points.size() < 4) return {};
  const auto farthest = [&](auto&& measure) {
    Index best = 0;
    double most = -1;
    for (Index i = 0; i < points.size(); ++i)
      if (const double value = measure(points[i]); value > most) {
        most = value;
        best = i;
      }
    return best;
  };
  const Vector3 a = points[0];
  const Index ib = farthest([&](const Vector3& p) { return (p - a).squaredNorm(); });
  const Vector3 b = points[ib];
  const Index ic = farthest([&](const Vector3& p) { return (p - a).cross(b - a).squaredNorm(); });
  const Vector3 c = points[ic], normal = (b - a).cross(c - a);
  Index id = farthest([&](const Vector3& p) { return std::abs(normal.dot(p - a)); });
  for (Index i = 0; side_of_plane(a, b, c, points[id]) == 0; ++i) {
    if (i == points.size()) return {};
    id = i;
  }
  return std::array<Index, 4>{0, ib, ic, id};
}

}  // namespace

bool ConvexHull::begin(const std::array<Index, 4>& corners) {
  std::array<Index, 4> v = corners;
  const int side = side_of_plane(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]);
  if (side == 0) return false;
  if (side > 0) std::swap(v[1], v[2]);  // v3 then lies below the face v0 v1 v2
  inner_ = (points_[v[0]] + points_[v[1]] + points_[v[2]] + points_[v[3]]) / 4;
  faces_ = {{{v[0], v[1], v[2]}, {1, 2, 3}},
            {{v[1], v[0], v[3]}, {0, 3, 2}},
            {{v[2], v[1], v[3]}, {0, 1, 3}},
            {{v[0], v[2], v[3]}, {0, 2, 1}}};
  for (Index f = 0; f < 4; ++f)
    if (sees(inner_, f)) return false;  // so flat that rounding puts the centre outside
  return true;
}

std::optional<ConvexHull> ConvexHull::build(std::vector<Vector3> points) {
  const auto first = spanning_points(points);
  if (!first) return {};
  ConvexHull hull;
  hull.points_ = std::move(points);
  if (!hull.begin(*first)) return {};
  for (Index i = 0; i < hull.points_.size(); ++i) {
    const Vector3& point = hull.points_[i];
    if (const Index seed = hull.visible_face(point); seed != no_index)
      hull.connect(i, hull.horizon(point, seed));
  }
  return hull;
}

bool ConvexHull::sees(const Vector3& point, Index face) const {
  const auto& v = faces_[face].corner;
  return side_of_plane(points_[v[0]], points_[v[1]], points_[v[2]], point) > 0;
}

Index ConvexHull::walk(const Vector3& point) const {
  Index face = static_cast<Index>(faces_.size());
  while (!faces_[--face].alive) {
  }
  // The faces, seen from inside, need not be a Delaunay triangulation, so a walk could run in circles: the
  // edge tried first changes from step to step, and in the end all faces are tested.
  const std::size_t limit = 100 + 4 * faces_.size();
  Index came_from = no_index;
  for (std::size_t step = 0; step < limit; ++step) {
    const Face& at = faces_[face];
    Index next = no_index;
    for (std::size_t i = 0; i < 3 && next == no_index; ++i) {
      const std::size_t k = (i + step) % 3;
      if (at.neighbour[k] == came_from) continue;
      const Vector3 &a = points_[at.corner[k]], &b = points_[at.corner[(k + 1) % 3]];
      if (side_of_plane(inner_, a, b, point) < 0) next = at.neighbour[k];
    }
    if (next == no_index) return face;
    came_from = face;
    face = next;
  }
  return no_index;
}

Index ConvexHull::visible_face(const Vector3& point) const {
  const Index pierced = walk(point);
  if (pierced != no_index) {
    if (sees(point, pierced)) return pierced;
    // The ray from inside leaves the hull in the pierced face, so a point beyond the hull sees it.
    return no_index;
  }
  for (Index f = 0; f < faces_.size(); ++f)
    if (faces_[f].alive && sees(point, f)) return f;
  return no_index;
}

ConvexHull::Horizon ConvexHull::horizon(const Vector3& point, Index seed) const {
  Horizon out;
  out.faces.push_back(seed);
  // One flag per face of a small hull. Clearing flags for all faces of a large hull would cost more than a
  // search in the list of visible faces, which is mostly short.
  std::vector<char> seen(faces_.size() > 4096 ? 0 : faces_.size(), 0);
  const auto known = [&](Index face) {
    if (!seen.empty()) return seen[face] != 0;
    return std::find(out.faces.begin(), out.faces.end(), face) != out.faces.end();
  };
  if (!seen.empty()) seen[seed] = 1;
  std::vector<Horizon::Edge> edges;
  for (std::size_t i = 0; i < out.faces.size(); ++i) {
    const Face face = faces_[out.faces[i]];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index next = face.neighbour[k];
      if (known(next)) continue;
      if (sees(point, next)) {
        if (!seen.empty()) seen[next] = 1;
        out.faces.push_back(next);
      } else {
        edges.push_back({face.corner[k], face.corner[(k + 1) % 3], next});
      }
    }
  }
  // Links the edges: each begins where the one before ends.
  out.edges.reserve(edges.size());
  out.edges.push_back(edges.front());
  while (out.edges.size() < edges.size()) {
    const auto next = std::find_if(edges.begin(), edges.end(), [&](const Horizon::Edge& edge) {
      return edge.from == out.edges.back().to;
    });
    HARIKO_ASSERT(next != edges.end(), "the horizon is not a cycle");
    out.edges.push_back(*next);
  }
  return out;
}

void ConvexHull::connect(Index point, const Horizon& horizon) {
  const Index first = static_cast<Index>(faces_.size()), count = static_cast<Index>(horizon.edges.size());
  for (const Index face : horizon.faces) faces_[face].alive = false;
  for (Index i = 0; i < count; ++i) {
    const Horizon::Edge& edge = horizon.edges[i];
    faces_.push_back({{edge.from, edge.to, point},
                      {edge.beyond, first + (i + 1) % count, first + (i + count - 1) % count}});
    Face& beyond = faces_[edge.beyond];
    for (std::size_t k = 0; k < 3; ++k)
      if (beyond.corner[k] == edge.to && beyond.corner[(k + 1) % 3] == edge.from)
        beyond.neighbour[k] = first + i;
  }
}

Index ConvexHull::insert(const Vector3& point, const Horizon& horizon) {
  points_.push_back(point);
  const Index number = static_cast<Index>(points_.size() - 1);
  connect(number, horizon);
  return number;
}

}  // namespace hariko
