#include "core/gaussmap/lloyd_relaxed_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/gaussmap/sphere/edge_flips.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {
namespace {

using Triangle = std::array<Index, 3>;

Vector3 area_of_triangle(const std::vector<Vector3>& points, Index a, Index b, Index c) {
  return area_vector(points[a], points[b], points[c]);
}

/// Cotangent of the angle at `tip` in the triangle over the edge a b.
double cotangent(const std::vector<Vector3>& points, Index a, Index b, Index tip) {
  const Vector3 u = points[a] - points[tip], v = points[b] - points[tip];
  return u.dot(v) / std::max(u.cross(v).norm(), 1e-300);
}

std::vector<Triangle> flipped(const std::vector<Vector3>& points, std::vector<Triangle> triangles) {
  constexpr double slack = 1e-6;  // prevents repeated flips by rounding
  return flip_edges(std::move(triangles), Index(points.size()), 3, [&](Index p, Index q, Index r, Index s) {
    if (cotangent(points, p, q, r) + cotangent(points, q, p, s) >= -slack) return false;
    const Vector3 normal = area_of_triangle(points, p, q, r) + area_of_triangle(points, q, p, s);
    return area_of_triangle(points, p, s, r).dot(normal) > 0 &&
           area_of_triangle(points, s, q, r).dot(normal) > 0;
  });
}

/// Opposite edges (from, to) of the triangles of each inner vertex, in any order.
std::vector<std::vector<std::pair<Index, Index>>> opposite_edges(const PositionMesh& mesh) {
  std::vector<std::vector<std::pair<Index, Index>>> out(mesh.points.size());
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (triangle[k] >= mesh.boundary_count)
        out[triangle[k]].emplace_back(triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
  return out;
}

/// Triangles round a vertex, projected into its tangent plane with the vertex at the origin.
class FlatStar {
 public:
  FlatStar(const std::vector<Vector3>& points, Index vertex,
           const std::vector<std::pair<Index, Index>>& opposite) {
    Vector3 normal = Vector3::Zero();
    for (const auto& [a, b] : opposite) normal += area_of_triangle(points, vertex, a, b);
    if (!(normal.norm() > 0)) return;
    u_ = normal.unitOrthogonal();
    w_ = normal.normalized().cross(u_);
    const auto flat = [&](Index k) {
      const Vector3 d = points[k] - points[vertex];
      return Vector2(d.dot(u_), d.dot(w_));
    };
    for (const auto& [a, b] : opposite) sides_.push_back({flat(a), flat(b)});
  }
  bool empty() const { return sides_.empty(); }
  Vector3 lift(const Vector2& in) const { return in.x() * u_ + in.y() * w_; }

  /// Centroid of the Voronoi cell: the signed parts of the cell over each triangle add up to the cell
  /// wherever the circumcentres lie.
  Vector2 cell_centroid() const {
    Vector2 moment = Vector2::Zero();
    double area = 0;
    for (const auto& [a, b] : sides_) {
      const double twice = cross(a, b);
      if (!(twice > 0)) return Vector2::Zero();
      const Vector2 turned(a.squaredNorm() * b.y() - b.squaredNorm() * a.y(),
                           b.squaredNorm() * a.x() - a.squaredNorm() * b.x());
      const Vector2 centre = turned / (2 * twice);
      for (const auto& [from, to] : {std::pair(Vector2(a / 2), centre), {centre, Vector2(b / 2)}}) {
        const double part = cross(from, to) / 2;
        area += part;
        moment += part * (from + to) / 3;
      }
    }
    return area > 0 ? Vector2(moment / area) : Vector2::Zero();
  }

  /// Whether no triangle is inverted with the vertex at `place`.
  bool holds(const Vector2& place) const {
    return std::all_of(sides_.begin(), sides_.end(), [&](const Side& side) {
      return cross(side.from - place, side.to - place) > 0.1 * cross(side.from, side.to);
    });
  }

 private:
  struct Side {
    Vector2 from, to;
  };
  Vector3 u_, w_;
  std::vector<Side> sides_;
};

/// Whether a place lies in the diametral ball of an edge of a loop.
bool near_loop(const PositionMesh& mesh, const std::vector<std::pair<Index, Index>>& opposite,
               const Vector3& place) {
  return std::any_of(opposite.begin(), opposite.end(), [&](const std::pair<Index, Index>& edge) {
    const auto& [a, b] = edge;
    return a < mesh.boundary_count && b < mesh.boundary_count &&
           (mesh.points[a] - place).dot(mesh.points[b] - place) < 0;
  });
}

}  // namespace

void spread_evenly(PositionMesh& mesh, int rounds) {
  constexpr double reach = 1.5;  // step relative to that to the centroid: as even in half the rounds
  for (int round = 0; round < rounds; ++round) {
    mesh.triangles = flipped(mesh.points, std::move(mesh.triangles));
    const auto opposite = opposite_edges(mesh);
    for (Index i = mesh.boundary_count; i < mesh.points.size(); ++i) {
      const FlatStar star(mesh.points, i, opposite[i]);
      if (star.empty()) continue;
      const Vector2 move = reach * star.cell_centroid();
      const Vector3 place = mesh.points[i] + star.lift(move);
      if (place.allFinite() && star.holds(move) && !near_loop(mesh, opposite[i], place))
        mesh.points[i] = place;
    }
  }
  mesh.triangles = flipped(mesh.points, std::move(mesh.triangles));
}

}  // namespace hariko
