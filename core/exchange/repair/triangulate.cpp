#include "core/exchange/repair/triangulate.hpp"

#include <algorithm>
#include <numeric>

#include "core/geometry/polygon.hpp"

namespace hariko {
namespace {

/// Number of corners up to which all are tested for each ear. Above it only reflex corners are: in a simple
/// polygon every triangle that is no ear contains one of them.
constexpr std::size_t largest_for_all = 1000;
/// Limit of steps for a polygon; the rest then becomes a fan.
constexpr std::size_t most_steps = 400'000'000;

/// Corners projected to a plane in which the polygon runs counter-clockwise.
std::vector<Vector2> project(std::span<const Vector3> corners) {
  const Vector3 normal = newell_normal(corners);
  int drop = 0;
  normal.cwiseAbs().maxCoeff(&drop);
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  const double side = normal[drop] < 0 ? -1 : 1;
  std::vector<Vector2> out;
  out.reserve(corners.size());
  for (const Vector3& p : corners) out.emplace_back(p[u] - corners[0][u], side * (p[v] - corners[0][v]));
  return out;
}

bool is_ear(const std::vector<Vector2>& points, const std::vector<Index>& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Vector2 &a = points[ring[(i + n - 1) % n]], &b = points[ring[i]], &c = points[ring[(i + 1) % n]];
  if (!(twice_area(a, b, c) > 0)) return false;
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const Vector2& p = points[ring[(i + k) % n]];
    if (twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0) return false;
  }
  return true;
}

/// Clips the ears of a polygon with few corners. The rest in `ring` has no ear.
void cut_ears(const std::vector<Vector2>& points, std::vector<Index>& ring,
              std::vector<std::array<Index, 3>>& out) {
  std::size_t i = 0, failures = 0;
  while (ring.size() > 3 && failures < ring.size()) {
    i %= ring.size();
    if (!is_ear(points, ring, i)) {
      ++i;
      ++failures;
      continue;
    }
    const std::size_t n = ring.size();
    out.push_back({ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    ++i;  // cuts a neighbour later, which gives better triangles
    failures = 0;
  }
}

/// Clips the ears of a polygon with many corners, in a linked ring. O(corners * reflex corners).
class LongPolygon {
 public:
  explicit LongPolygon(const std::vector<Vector2>& points)
      : points_(points), next_(points.size()), before_(points.size()), left_(points.size()) {
    const auto n = static_cast<Index>(points.size());
    for (Index i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      before_[i] = (i + n - 1) % n;
    }
    for (Index i = 0; i < n; ++i)
      if (!bends_outward(i)) inward_.push_back(i);
  }

  void cut(std::vector<std::array<Index, 3>>& out) {
    std::size_t failures = 0;
    Index at = 0;
    while (left_ > 3 && failures < left_ && steps_ < most_steps) {
      if (!is_free(at)) {
        at = next_[at];
        ++failures;
        continue;
      }
      out.push_back({before_[at], at, next_[at]});
      next_[before_[at]] = next_[at];
      before_[next_[at]] = before_[at];
      --left_;
      // Removes neighbours that have become convex; they stay convex.
      std::erase_if(inward_, [&](Index i) {
        return i == at || ((i == before_[at] || i == next_[at]) && bends_outward(i));
      });
      at = next_[next_[at]];
      failures = 0;
    }
    first_ = before_[next_[at]];
  }
  std::vector<Index> ring() const {
    std::vector<Index> out;
    Index at = first_;
    for (std::size_t k = 0; k < left_; ++k, at = next_[at]) out.push_back(at);
    return out;
  }

 private:
  bool bends_outward(Index i) const {
    return twice_area(points_[before_[i]], points_[i], points_[next_[i]]) > 0;
  }
  bool is_free(Index i) {
    if (!bends_outward(i)) return false;
    steps_ += 1 + inward_.size();
    const Vector2 &a = points_[before_[i]], &b = points_[i], &c = points_[next_[i]];
    return std::none_of(inward_.begin(), inward_.end(), [&](Index k) {
      const Vector2& p = points_[k];
      return k != before_[i] && k != next_[i] && twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 &&
             twice_area(c, a, p) >= 0;
    });
  }

  const std::vector<Vector2>& points_;
  std::vector<Index> next_, before_, inward_;
  std::size_t left_, steps_ = 0;
  Index first_ = 0;
};

}  // namespace

std::vector<std::array<Index, 3>> triangulate_polygon(std::span<const Vector3> corners) {
  std::vector<std::array<Index, 3>> out;
  if (corners.size() < 3) return out;
  std::vector<Index> ring(corners.size());
  std::iota(ring.begin(), ring.end(), Index{0});
  if (ring.size() > largest_for_all) {
    const std::vector<Vector2> points = project(corners);
    LongPolygon polygon(points);
    polygon.cut(out);
    ring = polygon.ring();
  } else if (ring.size() > 3) {
    cut_ears(project(corners), ring, out);
  }
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) out.push_back({ring[0], ring[i], ring[i + 1]});
  return out;
}

FaceTriangles triangulate(const PolygonMesh& mesh) {
  FaceTriangles out;
  std::vector<Vector3> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() < 3) continue;
    corners.clear();
    for (const Index v : face) corners.push_back(mesh.positions[v]);
    for (const auto& [a, b, c] : triangulate_polygon(corners)) {
      out.triangles.push_back({face[a], face[b], face[c]});
      out.faces.push_back(Index(f));
    }
  }
  return out;
}

}  // namespace hariko
