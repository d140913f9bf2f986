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
  /// Facet in one plane.
  struct Facet {
    std::vector<Vector3> corners;  ///< counter-clockwise from outside
    /// Plane beyond the edge from corner k to corner k + 1; no_index for far planes.
    std::vector<Index> neighbours;
  };

  /// Makes the polytope. `inner`: a point strictly inside all planes; `size`: length scale that determines
  /// the distance of the far planes. Nothing when `inner` is not inside or its polar dual is flat. Expected
  /// O(planes log planes).
  static std::optional<TangentPolytope> build(std::span<const Vector3> normals,
                                              std::span<const double> support, const Vector3& inner,
                                              double size);

  /// Facets by plane; empty where the plane does not touch the polytope.
  const std::vector<Facet>& facets() const { return facets_; }
  /// Area of a plane's facet, whose unit normal is given.
  double area(Index plane, const Vector3& normal) const;
  /// Corner that is farthest in a direction.
  Vector3 farthest(const Vector3& direction) const;
  /// Triples of planes that meet in a corner, counter-clockwise: the dual's faces, without far planes.
  const std::vector<std::array<Index, 3>>& corner_planes() const { return corner_planes_; }

 private:
  std::vector<Facet> facets_;
  std::vector<Vector3> corners_;
  std::vector<std::array<Index, 3>> corner_planes_;
};

/// Point well inside all planes: the mean of `points`, moved towards the centre of the largest inscribed ball
/// where the mean is nearly on a plane (gaussmap.md 4). Nothing when the planes have no common interior.
std::optional<Vector3> inner_point(std::span<const Vector3> normals, std::span<const double> support,
                                   std::span<const Vector3> points, double size);

/// Area of a polygon in a plane with this unit normal.
double polygon_area(std::span<const Vector3> corners, const Vector3& normal);

}  // namespace hariko
