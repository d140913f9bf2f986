#pragma once

// TangentPolytope: intersection of half-spaces through polar duality. Internal to core/gaussmap.

#include <optional>
#include <span>
#include <vector>

#include "core/geometry/convex_hull.hpp"

namespace hariko {

/// Polytope {x : normal_i . x <= support_i}. Six far planes bound it where the planes leave it open.
class TangentPolytope {
 public:
  /// Makes the polytope. `inner`: a point strictly inside all planes; `size`: length scale that determines
  /// the distance of the far planes. Nothing when `inner` is not inside or its polar dual is flat. Expected
  /// O(planes log planes).
  static std::optional<TangentPolytope> build(std::span<const Vector3> normals,
                                              std::span<const double> support, const Vector3& inner,
                                              double size);

  /// Corners of each plane's facet, counter-clockwise from outside; empty where the plane does not touch the
  /// polytope.
  const std::vector<std::vector<Vector3>>& facets() const { return facets_; }
  /// Corner that is farthest in a direction.
  Vector3 farthest(const Vector3& direction) const;

 private:
  std::vector<std::vector<Vector3>> facets_;
  std::vector<Vector3> corners_;
};

/// Point well inside all planes: the mean of `points`, moved towards the centre of the largest inscribed ball
/// where the mean is nearly on a plane (gaussmap.md 4). Nothing when the planes have no common interior.
std::optional<Vector3> inner_point(std::span<const Vector3> normals, std::span<const double> support,
                                   std::span<const Vector3> points, double size);

}  // namespace hariko
