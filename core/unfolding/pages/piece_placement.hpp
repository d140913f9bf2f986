#pragma once

// PiecePlacement: position of a piece on a page, as a rotation and a translation.

#include <cmath>

#include "core/unfolding/cuts/facet_layout.hpp"

namespace hariko {

/// Rigid motion from a piece's own frame to a page: p becomes R(angle) p + offset, in mm, x to the right, y
/// up from the lower left corner. Angles in radians, counter-clockwise.
struct PiecePlacement {
  Index page = 0;
  double angle = 0;
  Vector2 offset = Vector2::Zero();

  Vector2 apply(const Vector2& p) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x() - s * p.y() + offset.x(), s * p.x() + c * p.y() + offset.y()};
  }
  template <std::size_t N>
  std::array<Vector2, N> apply(const std::array<Vector2, N>& points) const {
    const double c = std::cos(angle), s = std::sin(angle);
    std::array<Vector2, N> out;
    for (std::size_t k = 0; k < N; ++k)
      out[k] = {c * points[k].x() - s * points[k].y() + offset.x(),
                s * points[k].x() + c * points[k].y() + offset.y()};
    return out;
  }
  /// Same placement, rotated by `turn` about a point of the page.
  PiecePlacement turned(double turn, const Vector2& centre) const {
    const PiecePlacement rotation{page, turn, Vector2::Zero()};
    return {page, angle + turn, rotation.apply(Vector2(offset - centre)) + centre};
  }
  friend bool operator==(const PiecePlacement&, const PiecePlacement&) = default;
};

/// Placement that takes one triangle to another of the same shape (up to rounding).
inline PiecePlacement placement_between(const FacetCorners& from, const FacetCorners& to, Index page) {
  std::size_t side = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if ((from[(k + 1) % 3] - from[k]).norm() > (from[(side + 1) % 3] - from[side]).norm()) side = k;
  const Vector2 a = from[(side + 1) % 3] - from[side], b = to[(side + 1) % 3] - to[side];
  PiecePlacement out{page, std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)), Vector2::Zero()};
  out.offset = to[side] - out.apply(from[side]);
  return out;
}

}  // namespace hariko
