#include "core/modeling/face_geometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/polyhedron/face_shape.hpp"

namespace hariko {
namespace {

std::vector<Vector3> corners_of(const Polyhedron& polyhedron, Index face) {
  std::vector<Vector3> corners;
  for (const Index v : polyhedron.topology().face_vertices(face)) corners.push_back(polyhedron.position(v));
  return corners;
}

/// Half of it, so that nothing overflows.
double extent_of(const std::vector<Vector3>& corners) {
  double extent = 0;
  for (const Vector3& p : corners) extent = std::max(extent, (p / 2 - corners[0] / 2).cwiseAbs().maxCoeff());
  return extent;
}

/// Newell's normal in units of `extent` squared, so that neither large nor small faces leave the range.
Vector3 scaled_normal(std::vector<Vector3> corners, double extent) {
  if (!(extent > 0)) return Vector3::Zero();
  const Vector3 first = corners[0];
  for (Vector3& p : corners) p = (p / 2 - first / 2) / extent;
  return newell_normal(corners);
}

}  // namespace

Vector3 direction_of(const Vector3& vector) {
  const double largest = vector.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) return Vector3::Zero();
  return (vector / largest).normalized();
}

Vector3 face_normal(const Polyhedron& polyhedron, Index face) {
  std::vector<Vector3> corners = corners_of(polyhedron, face);
  const double extent = extent_of(corners);
  const Vector3 normal = scaled_normal(std::move(corners), extent);
  // Below this the direction is that of rounding errors.
  return normal.norm() > 1e-12 ? direction_of(normal) : Vector3::Zero();
}

Vector3 mean_normal(const Polyhedron& polyhedron, std::span<const Index> faces) {
  double extent = 0;
  for (const Index f : faces) extent = std::max(extent, extent_of(corners_of(polyhedron, f)));
  Vector3 sum = Vector3::Zero();
  double total = 0;
  for (const Index f : faces) {
    const Vector3 normal = scaled_normal(corners_of(polyhedron, f), extent);
    sum += normal;
    total += normal.norm();
  }
  return sum.norm() > 1e-9 * total ? direction_of(sum) : Vector3::Zero();
}

Vector3 inward_direction(const Polyhedron& polyhedron, Index half_edge) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const Vector3 along =
      polyhedron.position(mesh.target(half_edge)) - polyhedron.position(mesh.origin(half_edge));
  return direction_of(face_normal(polyhedron, mesh.face(half_edge)).cross(direction_of(along)));
}

Vector3 miter(const Vector3& a, const Vector3& b) {
  if (a.isZero(0)) return b;
  if (b.isZero(0)) return a;
  return (a + b) / std::max(1 + a.dot(b), 0.02);
}

FaceId first_turned_face(const Polyhedron& before, const Polyhedron& after) {
  for (Index f = 0; f < before.face_count(); ++f) {
    const Index kept = after.find(before.face_id(f));
    if (kept != no_index && face_normal(before, f).dot(face_normal(after, kept)) < 0)
      return before.face_id(f);
  }
  return {};
}

Vector3 face_centre(const Polyhedron& polyhedron, Index face) {
  const auto vertices = polyhedron.topology().face_vertices(face);
  const auto count = static_cast<double>(vertices.size());
  Vector3 centre = Vector3::Zero();
  for (const Index v : vertices) centre += polyhedron.position(v) / count;
  return centre;
}

double collapse_amount(const Slide& a, const Slide& b) {
  const Vector3 edge = b.position - a.position;
  const Vector3 along = direction_of(edge);
  const double shrinking = (a.rate - b.rate).dot(along);
  return shrinking > 0 && !along.isZero(0) ? edge.dot(along) / shrinking
                                           : std::numeric_limits<double>::infinity();
}

}  // namespace hariko
