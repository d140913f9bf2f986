#pragma once

// Triangles in space: areas, normals, angles, distances.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/base/vector.hpp"
#include "core/geometry/angles.hpp"

namespace hariko {

using TriangleCorners = std::array<Vector3, 3>;

/// Area vector: at right angles to the triangle, as long as twice its area.
inline Vector3 area_vector(const Vector3& a, const Vector3& b, const Vector3& c) {
  return (b - a).cross(c - a);
}

/// Squared distance of `p` to the segment ab.
inline double squared_distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 edge = b - a, offset = p - a;
  const double length = edge.squaredNorm();
  const double t = length > 0 ? std::clamp(offset.dot(edge) / length, 0.0, 1.0) : 0.0;
  return (offset - t * edge).squaredNorm();
}

/// Point of the segment ab nearest to `p`.
inline Vector3 nearest_point_of_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 edge = b - a;
  const double length = edge.squaredNorm();
  return a + (length > 0 ? std::clamp((p - a).dot(edge) / length, 0.0, 1.0) : 0.0) * edge;
}

/// Triangle prepared for many distance queries. A triangle without area counts as its longest side.
class ClosedTriangle {
 public:
  /// Prepares the triangle; O(1).
  explicit ClosedTriangle(const TriangleCorners& corners) : p_(corners) {
    const Vector3 e = p_[1] - p_[0], f = p_[2] - p_[0];
    const Vector3 normal = e.cross(f);
    const double square = normal.squaredNorm(), size = std::max(e.squaredNorm(), f.squaredNorm());
    flat_ = square > 1e-24 * size * size;
    if (!flat_) return;
    normal_ = normal / std::sqrt(square);
    second_ = f.cross(normal) / square;  // second_ . (x - p0) is the coordinate of corner 1
    third_ = normal.cross(e) / square;
  }

  /// Unit normal; zero for a triangle without area.
  const Vector3& normal() const { return normal_; }

  /// Squared distance of `p` to the closed triangle.
  double squared_distance(const Vector3& p) const {
    if (flat_) {
      const Vector3 w = p - p_[0];
      const double b = second_.dot(w), c = third_.dot(w);
      if (is_inside(b, c)) {
        const double height = normal_.dot(w);
        return height * height;
      }
      // The nearest point is on a side that the projection lies beyond.
      double nearest = std::numeric_limits<double>::infinity();
      if (b + c > 1) nearest = squared_distance_to_segment(p, p_[1], p_[2]);
      if (b < 0) nearest = std::min(nearest, squared_distance_to_segment(p, p_[2], p_[0]));
      if (c < 0) nearest = std::min(nearest, squared_distance_to_segment(p, p_[0], p_[1]));
      return nearest;
    }
    return std::min({squared_distance_to_segment(p, p_[0], p_[1]),
                     squared_distance_to_segment(p, p_[1], p_[2]),
                     squared_distance_to_segment(p, p_[2], p_[0])});
  }
  /// Largest squared distance of several points to the closed triangle.
  double largest_squared_distance(std::span<const Vector3> points) const {
    double worst = 0;
    for (const Vector3& p : points) {
      // Most projections lie inside: only the others need the sides.
      const Vector3 w = p - p_[0];
      const double b = second_.dot(w), c = third_.dot(w), height = normal_.dot(w);
      const bool inside = flat_ && is_inside(b, c);
      worst = std::max(worst, inside ? height * height : squared_distance(p));
    }
    return worst;
  }
  double distance(const Vector3& p) const { return std::sqrt(squared_distance(p)); }
  /// Point of the closed triangle nearest to `p`; of equally near ones that of the first side.
  Vector3 nearest_point(const Vector3& p) const {
    if (flat_) {
      const Vector3 w = p - p_[0];
      if (is_inside(second_.dot(w), third_.dot(w))) return p - normal_.dot(w) * normal_;
    }
    Vector3 nearest = nearest_point_of_segment(p, p_[0], p_[1]);
    for (std::size_t i = 1; i < 3; ++i) {
      const Vector3 other = nearest_point_of_segment(p, p_[i], p_[(i + 1) % 3]);
      if ((p - other).squaredNorm() < (p - nearest).squaredNorm()) nearest = other;
    }
    return nearest;
  }
  /// Signed distance of `p` to the plane, positive on the side that the normal points to; 0 without an area.
  double height(const Vector3& p) const { return normal_.dot(p - p_[0]); }
  /// Distance along a ray of unit direction to the point in which it meets the triangle, negative behind the
  /// ray's begin. The triangle is enlarged by `rim` of its size, so that no ray slips between neighbours.
  /// Nothing for rays that miss it or lie in its plane, and for triangles without area.
  std::optional<double> meets(const Vector3& begin, const Vector3& direction, double rim) const {
    const double slope = normal_.dot(direction);
    if (slope == 0) return std::nullopt;
    const double along = -height(begin) / slope;
    const Vector3 w = begin + along * direction - p_[0];
    const double b = second_.dot(w), c = third_.dot(w);
    if (!(b >= -rim && c >= -rim && b + c <= 1 + rim)) return std::nullopt;
    return along;
  }

 private:
  /// Whether a projection lies inside; projections on a side count, although rounding may put them beyond it.
  static bool is_inside(double b, double c) {
    constexpr double rounding = 1e-13;
    return b >= -rounding && c >= -rounding && b + c <= 1 + rounding;
  }
  TriangleCorners p_;
  Vector3 normal_ = Vector3::Zero(), second_ = Vector3::Zero(), third_ = Vector3::Zero();
  bool flat_ = false;
};

/// Whether an angle of the triangle is below the one with the given tangent, at most a right angle.
inline bool has_sharp_angle(const TriangleCorners& p, double tangent) {
  const Vector3 e = p[1] - p[0], f = p[2] - p[1], g = p[0] - p[2];
  const double area = e.cross(f).norm();  // twice; the same from every corner
  return area < tangent * std::max({-e.dot(g), -f.dot(e), -g.dot(f)});
}

/// Unit normal; zero for a triangle with less than 1e-12 of its squared longest side as doubled area.
inline Vector3 facet_normal(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 normal = area_vector(a, b, c);
  const double size = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
  const double length = normal.norm();
  return length > 1e-12 * size ? Vector3(normal / length) : Vector3::Zero();
}

/// Smallest interior angle, radians.
inline double smallest_angle(const TriangleCorners& p) {
  double out = 4;
  for (std::size_t c = 0; c < 3; ++c)
    out = std::min(out, angle_between(p[(c + 1) % 3] - p[c], p[(c + 2) % 3] - p[c]));
  return out;
}

}  // namespace hariko
