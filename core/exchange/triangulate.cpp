#include "core/exchange/triangulate.hpp"

#include <Eigen/Geometry>
#include <numeric>

namespace hariko {
namespace {

constexpr std::size_t largest_for_ears = 1000;

/// The corners in a plane in which the polygon runs counter-clockwise.
std::vector<Vector2> project(std::span<const Vector3> corners) {
  Vector3 normal = Vector3::Zero();  // Newell's, relative to the first corner against cancellation
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  int drop = 0;
  normal.cwiseAbs().maxCoeff(&drop);
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  const double side = normal[drop] < 0 ? -1 : 1;
  std::vector<Vector2> out;
  out.reserve(corners.size());
  for (const Vector3& p : corners) out.emplace_back(p[u] - corners[0][u], side * (p[v] - corners[0][v]));
  return out;
}

double area(const Vector2& a, const Vector2& b, const Vector2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool is_ear(const std::vector<Vector2>& points, const std::vector<Index>& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Vector2 &a = points[ring[(i + n - 1) % n]], &b = points[ring[i]], &c = points[ring[(i + 1) % n]];
  if (!(area(a, b, c) > 0)) return false;
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const Vector2& p = points[ring[(i + k) % n]];
    if (area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0) return false;
  }
  return true;
}

}  // namespace

std::vector<std::array<Index, 3>> triangulate_polygon(std::span<const Vector3> corners) {
  std::vector<std::array<Index, 3>> out;
  if (corners.size() < 3) return out;
  std::vector<Index> ring(corners.size());
  std::iota(ring.begin(), ring.end(), Index{0});
  if (ring.size() > 3 && ring.size() <= largest_for_ears) {
    const std::vector<Vector2> points = project(corners);
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
      ++i;  // a neighbour of the cut is left for later, which gives better triangles
      failures = 0;
    }
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
