#include "core/modeling/cuts/diagonal.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "core/geometry/polygon.hpp"
#include "core/modeling/operations/face_geometry.hpp"

namespace hariko {
namespace {

bool segments_cross(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return ((c_side >= 0 && d_side <= 0) || (c_side <= 0 && d_side >= 0)) &&
         ((a_side >= 0 && b_side <= 0) || (a_side <= 0 && b_side >= 0));
}

/// Whether the direction from `at` to `to` lies inside the corner between the sides to the next and the
/// previous corner.
bool leaves_inside(const Vector2& previous, const Vector2& at, const Vector2& next, const Vector2& to) {
  const Vector2 out = next - at, in = previous - at, d = to - at;
  if (cross(out, in) >= 0) return cross(out, d) > 0 && cross(d, in) > 0;
  return !(cross(in, d) >= 0 && cross(d, out) >= 0);
}

}  // namespace

bool is_inner_diagonal(std::span<const Vector3> corners, std::size_t i, std::size_t j) {
  const std::size_t n = corners.size();
  if (i == j || (i + 1) % n == j || (j + 1) % n == i) return false;
  if (classify_face(corners) == FaceShape::convex) return true;
  double extent = 0;
  for (const Vector3& p : corners) extent = std::max(extent, (p - corners[0]).cwiseAbs().maxCoeff());
  std::vector<Vector3> scaled;
  for (const Vector3& p : corners) scaled.emplace_back((p - corners[0]) / extent);
  const Vector3 normal = direction_of(newell_normal(scaled));
  if (normal.isZero(0)) return true;
  const std::vector<Vector2> flat = flattened(scaled, Vector3::Zero(), normal);
  if (!leaves_inside(flat[(i + n - 1) % n], flat[i], flat[(i + 1) % n], flat[j]) ||
      !leaves_inside(flat[(j + n - 1) % n], flat[j], flat[(j + 1) % n], flat[i]))
    return false;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    if (k == i || k == j || next == i || next == j) continue;
    if (segments_cross(flat[i], flat[j], flat[k], flat[next])) return false;
  }
  return true;
}

}  // namespace hariko
