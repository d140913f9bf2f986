#include "core/gaussmap/halfspace_intersection.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/base/solvers/small_solver.hpp"

namespace hariko {
namespace {

constexpr double far_away = 30;  // relative to the size

/// Normals of the six far planes: a cube rotated so that no edge is parallel to those of typical models.
std::array<Vector3, 6> far_normals() {
  const Matrix3 turn = (Eigen::AngleAxisd(0.1, Vector3::UnitX()) * Eigen::AngleAxisd(0.23, Vector3::UnitY()) *
                        Eigen::AngleAxisd(0.37, Vector3::UnitZ()))
                           .toRotationMatrix();
  return {turn.col(0), turn.col(1), turn.col(2), -turn.col(0), -turn.col(1), -turn.col(2)};
}

double smallest_slack(std::span<const Vector3> normals, std::span<const double> support, const Vector3& at) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < normals.size(); ++i) least = std::min(least, support[i] - normals[i].dot(at));
  return least;
}

/// Centre of a nearly largest ball inside the planes and the far planes: Newton's method on a logarithmic
/// barrier over the centre and the radius.
Vector3 ball_centre(std::span<const Vector3> normals, std::span<const double> support, const Vector3& start,
                    double size) {
  std::vector<Eigen::Vector4d> rows;
  std::vector<double> limits;
  const auto add = [&](const Vector3& n, double h) {
    rows.emplace_back(n.x(), n.y(), n.z(), 1);
    limits.push_back(h);
  };
  for (std::size_t i = 0; i < normals.size(); ++i) add(normals[i], support[i]);
  for (const Vector3& n : far_normals()) add(n, n.dot(start) + far_away * size);
  Eigen::Vector4d x;
  x << start, smallest_slack(normals, support, start) - size;
  const auto feasible = [&](const Eigen::Vector4d& at) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (!(limits[i] - rows[i].dot(at) > 0)) return false;
    return true;
  };
  for (double sharpness = 1 / size; sharpness < 1e7 / size; sharpness *= 4)
    for (int step = 0; step < 8; ++step) {
      Eigen::Vector4d gradient(0, 0, 0, -sharpness);
      Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const double slack = limits[i] - rows[i].dot(x);
        gradient += rows[i] / slack;
        hessian += rows[i] * rows[i].transpose() / (slack * slack);
      }
      const Eigen::Vector4d move = solve_symmetric(hessian, -gradient);
      double share = 1;
      while (share > 1e-9 && !feasible(x + share * move)) share /= 2;
      if (share <= 1e-9) break;
      x += 0.95 * share * move;
      if (move.norm() < 1e-6 * size) break;
    }
  return x.head<3>();
}

}  // namespace

std::optional<Vector3> inner_point(std::span<const Vector3> normals, std::span<const double> support,
                                   std::span<const Vector3> points, double size) {
  Vector3 mean = Vector3::Zero();
  for (const Vector3& point : points) mean += point / double(points.size());
  if (smallest_slack(normals, support, mean) >= 1e-3 * size) return mean;
  const Vector3 centre = ball_centre(normals, support, mean, size);
  const Vector3 middle = (mean + centre) / 2;
  if (smallest_slack(normals, support, middle) > 1e-9 * size) return middle;
  if (smallest_slack(normals, support, centre) > 1e-9 * size) return centre;
  return {};
}

std::optional<TangentPolytope> TangentPolytope::build(std::span<const Vector3> normals,
                                                      std::span<const double> support, const Vector3& inner,
                                                      double size) {
  const Index count = static_cast<Index>(normals.size());
  std::vector<Vector3> duals;
  for (Index i = 0; i < count; ++i) {
    const double slack = support[i] - normals[i].dot(inner);
    if (!(slack > 1e-12 * size)) return {};
    duals.push_back(normals[i] / slack);
  }
  for (const Vector3& n : far_normals()) duals.push_back(n / (far_away * size));
  const auto hull = ConvexHull::build(std::move(duals));
  if (!hull) return {};
  TangentPolytope out;
  out.facets_.resize(count);
  const auto& faces = hull->faces();
  std::vector<Vector3> vertex(faces.size());
  std::vector<Index> face_of(hull->points().size(), no_index);
  const auto& d = hull->points();
  for (Index f = 0; f < faces.size(); ++f) {
    if (!faces[f].alive) continue;
    const auto& v = faces[f].corner;
    const Vector3 normal = (d[v[1]] - d[v[0]]).cross(d[v[2]] - d[v[0]]);
    const double offset = normal.dot(d[v[0]]);
    if (!(offset > 0)) return {};
    vertex[f] = inner + normal / offset;
    out.corners_.push_back(vertex[f]);
    for (const Index corner : v) face_of[corner] = f;
  }
  for (Index i = 0; i < count; ++i) {
    if (face_of[i] == no_index) continue;
    Index f = face_of[i];
    do {
      const auto& v = faces[f].corner;
      const std::size_t k = v[0] == i ? 0 : v[1] == i ? 1 : 2;
      out.facets_[i].push_back(vertex[f]);
      // The next face counter-clockwise round i lies beyond the edge from the previous corner to i.
      f = faces[f].neighbour[(k + 2) % 3];
    } while (f != face_of[i]);
  }
  return out;
}

Vector3 TangentPolytope::farthest(const Vector3& direction) const {
  HARIKO_ASSERT(!corners_.empty(), "a polytope has corners");
  return *std::max_element(corners_.begin(), corners_.end(), [&](const Vector3& a, const Vector3& b) {
    return direction.dot(a) < direction.dot(b);
  });
}

}  // namespace hariko
