#include "core/modeling/operations/face_geometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "core/geometry/polygon.hpp"

namespace hariko {
namespace {

/// Half the largest coordinate extent of the corners from the first one; halved so that nothing overflows.
double extent_of(const std::vector<Vector3>& corners) {
  double extent = 0;
  for (const Vector3& p : corners) extent = std::max(extent, (p / 2 - corners[0] / 2).cwiseAbs().maxCoeff());
  return extent;
}

/// Newell's normal in units of `extent` squared, so that neither large nor small faces overflow or underflow.
Vector3 scaled_normal(std::vector<Vector3> corners, double extent) {
  if (!(extent > 0)) return Vector3::Zero();
  const Vector3 first = corners[0];
  for (Vector3& p : corners) p = (p / 2 - first / 2) / extent;
  return newell_normal(corners);
}

/// Part of a convex polygon to the left of the line from a to b.
std::vector<Vector2> left_part(const std::vector<Vector2>& polygon, const Vector2& a, const Vector2& b) {
  const auto height = [&](const Vector2& p) { return cross(b - a, p - a); };
  std::vector<Vector2> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double from = height(p), to = height(q);
    if (from >= 0) out.push_back(p);
    if ((from < 0) != (to < 0)) out.push_back(p + from / (from - to) * (q - p));
  }
  return out;
}

/// Centroid of the kernel of a counter-clockwise polygon; nothing where the kernel's area is below 1e-6 of
/// the polygon's.
std::optional<Vector2> kernel_centroid(const std::vector<Vector2>& outline) {
  constexpr double least_share = 1e-6;
  Eigen::AlignedBox2d box;
  double area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    box.extend(outline[i]);
    area += cross(outline[i], outline[(i + 1) % outline.size()]) / 2;
  }
  std::vector<Vector2> kernel{
      box.min(), {box.max().x(), box.min().y()}, box.max(), {box.min().x(), box.max().y()}};
  for (std::size_t i = 0; i < outline.size(); ++i)
    kernel = left_part(kernel, outline[i], outline[(i + 1) % outline.size()]);
  Vector2 sum = Vector2::Zero();
  double whole = 0;
  for (std::size_t i = 0; i + 2 < kernel.size(); ++i) {
    const double part = cross(kernel[i + 1] - kernel[0], kernel[i + 2] - kernel[0]) / 2;
    sum += part / 3 * (kernel[0] + kernel[i + 1] + kernel[i + 2]);
    whole += part;
  }
  if (!(whole > least_share * area)) return std::nullopt;
  return Vector2(sum / whole);
}

}  // namespace

Vector3 direction_of(const Vector3& vector) {
  const double largest = vector.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) return Vector3::Zero();
  return (vector / largest).normalized();
}

Vector3 face_normal(const Polyhedron& polyhedron, Index face) {
  std::vector<Vector3> corners = polyhedron.corners(face);
  const double extent = extent_of(corners);
  const Vector3 normal = scaled_normal(std::move(corners), extent);
  // Below this length the direction would be that of rounding errors.
  return normal.norm() > 1e-12 ? direction_of(normal) : Vector3::Zero();
}

Vector3 mean_normal(const Polyhedron& polyhedron, std::span<const Index> faces) {
  double extent = 0;
  for (const Index f : faces) extent = std::max(extent, extent_of(polyhedron.corners(f)));
  Vector3 sum = Vector3::Zero();
  double total = 0;
  for (const Index f : faces) {
    const Vector3 normal = scaled_normal(polyhedron.corners(f), extent);
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

Result<Vector3> star_centre(const Polyhedron& polyhedron, Index face) {
  const std::vector<Vector3> corners = polyhedron.corners(face);
  Vector3 mean = Vector3::Zero();
  for (const Vector3& corner : corners) mean += corner / double(corners.size());
  if (classify_face(corners) == FaceShape::convex) return mean;
  const Vector3 normal = face_normal(polyhedron, face);
  const double extent = extent_of(corners);
  if (!normal.isZero(0)) {
    const Vector3 x = normal.unitOrthogonal(), y = normal.cross(x);
    std::vector<Vector2> outline;
    for (const Vector3& corner : corners) {
      const Vector3 p = (corner - mean) / extent;
      outline.emplace_back(p.dot(x), p.dot(y));
    }
    if (const auto centre = kernel_centroid(outline))
      return Vector3(mean + extent * (centre->x() * x + centre->y() * y));
  }
  const FaceId id = polyhedron.face_id(face);
  return make_error(e_no_centre,
                    "Face " + std::to_string(id.value) +
                        " has no point from which all of its corners are seen, so it cannot be divided "
                        "round one.",
                    "Decompose concave faces first.", element_of(id));
}

double collapse_amount(const Slide& a, const Slide& b) {
  const Vector3 edge = b.position - a.position;
  const Vector3 along = direction_of(edge);
  const double shrinking = (a.rate - b.rate).dot(along);
  return shrinking > 0 && !along.isZero(0) ? edge.dot(along) / shrinking
                                           : std::numeric_limits<double>::infinity();
}

}  // namespace hariko
