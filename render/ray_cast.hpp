#pragma once

// Ray intersection with triangles and boxes. Internal to render/.

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/camera.hpp"

namespace hariko {

/// Intersection of a ray with a triangle.
struct TriangleHit {
  double t = 0;         ///< ray parameter, >= 0
  double b = 0, c = 0;  ///< barycentric weights of the second and third corner
};

/// Intersection with a triangle, from both sides. It is enlarged by 1e-9 of its size, so that no ray slips
/// between neighbours. Nothing for degenerate triangles.
inline std::optional<TriangleHit> hit_triangle(const Ray& ray, const Vector3& p, const Vector3& q,
                                               const Vector3& r) {
  const Vector3 e1 = q - p, e2 = r - p, s = ray.direction.cross(e2);
  constexpr double rim = 1e-9;
  const double determinant = e1.dot(s);
  if (determinant == 0) return std::nullopt;
  const Vector3 from = ray.origin - p;
  const double b = from.dot(s) / determinant;
  if (!(b >= -rim && b <= 1 + rim)) return std::nullopt;
  const Vector3 w = from.cross(e1);
  const double c = ray.direction.dot(w) / determinant;
  if (!(c >= -rim && b + c <= 1 + rim)) return std::nullopt;
  const double t = e2.dot(w) / determinant;
  if (!(t >= 0)) return std::nullopt;
  return TriangleHit{t, b, c};
}

/// Whether the ray meets the box nearer than `limit`.
inline bool meets(const Ray& ray, const Box3& box, double limit) {
  double low = 0, high = limit;
  for (int i = 0; i < 3; ++i) {
    if (ray.direction[i] == 0) {
      if (ray.origin[i] < box.min()[i] || ray.origin[i] > box.max()[i]) return false;
      continue;
    }
    const double a = (box.min()[i] - ray.origin[i]) / ray.direction[i];
    const double b = (box.max()[i] - ray.origin[i]) / ray.direction[i];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return low <= high;
}

/// Ray in coordinates relative to `origin` inside an object; ray parameters are divided by `scale`.
struct LocalRay {
  Ray ray;
  double scale = 1;  ///< world length of a local unit
};
/// World ray in local coordinates of an object whose transform is a similarity.
inline LocalRay to_local(const Ray& ray, const Matrix4& transform, const Vector3& origin) {
  const Matrix3 linear = transform.topLeftCorner<3, 3>();
  const double scale = std::cbrt(std::abs(linear.determinant()));
  const Matrix3 back = linear.transpose() / (scale * scale);  // inverse of a similarity: its scaled transpose
  const Vector3 translation = transform.topRightCorner<3, 1>();
  return {{back * (ray.origin - translation) - origin, (back * ray.direction).normalized()}, scale};
}

}  // namespace hariko
