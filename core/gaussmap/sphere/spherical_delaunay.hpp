#pragma once

// SphereMesh: sites on the unit sphere, the part of their Delaunay triangulation inside the loops, and its
// Voronoi cells.

#include <array>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Immutable once built. Boundary sites come first, loop after loop.
class SphereMesh {
 public:
  using Triangle = std::array<Index, 3>;
  /// Neighbours and triangles around a site, counter-clockwise. Triangle t lies between neighbours t and t +
  /// 1. An inner site has as many neighbours as triangles; a boundary site has one more, from the next site
  /// of its loop to the previous one.
  struct Ring {
    std::vector<Index> neighbours, triangles;
  };

  /// Makes the mesh. `next`: the next site of the loop of each boundary site. Every triangle is
  /// counter-clockwise seen from outside, and each site's triangles make one fan (asserted for boundary
  /// sites).
  SphereMesh(std::vector<Vector3> sites, std::vector<Index> next, std::vector<Triangle> triangles);

  Index site_count() const { return static_cast<Index>(sites_.size()); }
  Index boundary_count() const { return static_cast<Index>(next_.size()); }
  Index inner_count() const { return site_count() - boundary_count(); }
  bool is_boundary(Index site) const { return site < boundary_count(); }
  const std::vector<Vector3>& sites() const { return sites_; }
  const Vector3& site(Index i) const { return sites_[i]; }
  Index next(Index boundary_site) const { return next_[boundary_site]; }
  Index previous(Index boundary_site) const { return previous_[boundary_site]; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// Voronoi vertices, one per triangle, unit vectors.
  const std::vector<Vector3>& centres() const { return centres_; }
  const Ring& ring(Index site) const { return rings_[site]; }

  /// Corners of the site's Voronoi cell, counter-clockwise, unit vectors; a boundary cell is clipped to the
  /// image and begins at the site itself (gaussmap.md 3).
  std::vector<Vector3> cell(Index site) const;
  /// Signed solid angle of the cell. The cells of all sites partition the image.
  double solid_angle(Index site) const;

 private:
  std::vector<Vector3> sites_;
  std::vector<Index> next_, previous_;
  std::vector<Triangle> triangles_;
  std::vector<Vector3> centres_;
  std::vector<Ring> rings_;
};

/// Centre of the circle through three points of the unit sphere, on the side from which they are
/// counter-clockwise.
Vector3 sphere_circumcentre(const Vector3& a, const Vector3& b, const Vector3& c);
/// Signed solid angle of a triangle on the unit sphere, positive when counter-clockwise from outside.
double solid_angle(const Vector3& a, const Vector3& b, const Vector3& c);
/// Nearest of the first `boundary_count` sites to site `of`: the point of the outline to name in errors about
/// that site.
Index nearest_boundary(const std::vector<Vector3>& sites, Index boundary_count, Index of);

}  // namespace hariko
