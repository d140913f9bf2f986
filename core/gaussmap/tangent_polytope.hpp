#pragma once

// TangentPolytope: what planes cut out of space, through polar duality. Internal to core/gaussmap.

#include <optional>
#include <span>
#include <vector>

#include "core/geometry/convex_hull.hpp"

namespace hariko {

/// {x : normal_i . x <= support_i}. Six far planes bound it where the planes leave it open.
class TangentPolytope {
 public:
  struct Facet {
    std::vector<Vector3> corners;  ///< counter-clockwise from outside
    std::vector<Index>
        neighbours;  ///< plane beyond the edge from corner k to corner k + 1; far planes are no_index
  };

  /// `inner`: a point strictly inside of all planes, beside it `size` says what is far. None when there is no
  /// such point or its polar dual is flat. O(planes log planes) expected.
  static std::optional<TangentPolytope> build(std::span<const Vector3> normals,
                                              std::span<const double> support, const Vector3& inner,
                                              double size);

  /// Empty where the plane cuts nothing.
  const std::vector<Facet>& facets() const { return facets_; }
  double area(Index plane, const Vector3& normal) const;
  /// The corner farthest in a direction, and how far.
  Vector3 farthest(const Vector3& direction) const;
  /// Triples of planes that meet in a corner, counter-clockwise: the dual's faces, without far planes.
  const std::vector<std::array<Index, 3>>& corner_planes() const { return corner_planes_; }

 private:
  std::vector<Facet> facets_;
  std::vector<Vector3> corners_;
  std::vector<std::array<Index, 3>> corner_planes_;
};

/// A point well inside of all planes: the mean of `points`, moved towards the centre of the largest ball
/// where that is nearly on a plane (gaussmap.md 4). None when the planes leave no room.
std::optional<Vector3> inner_point(std::span<const Vector3> normals, std::span<const double> support,
                                   std::span<const Vector3> points, double size);

/// Area of a polygon in a plane with this unit normal.
double polygon_area(std::span<const Vector3> corners, const Vector3& normal);

}  // namespace hariko
