#pragma once

// Grid of a surface as one triangle mesh, in which patches share their samples along seams.

#include <array>
#include <vector>

#include "core/drawing/surface_grid.hpp"

namespace hariko {

/// Triangles of all patches of a grid over common samples: the sample of a seam is one for both patches, a
/// side that has shrunk to a point is one sample, and where only a part of a side meets another (a T-joint),
/// each side also has the samples of the other. An edge with two triangles is therefore the same edge for
/// both, and the mesh of a surface without border is closed. Facets share nodes, and nodes at exactly the
/// same position are one. Triangles that have shrunk to an edge are left out. O(triangles log triangles).
class GridMesh {
 public:
  struct Triangle {
    Index patch;
    std::array<Index, 3> samples;  ///< all different
    std::array<int, 3> points;     ///< points of the patch, for `parameter`
    /// Whether edge k, from corner k to the next, is inside the patch. An edge inside is only that patch's,
    /// even where another patch has one between the same samples (near a corner of two patches).
    std::array<bool, 3> inside;
  };

  explicit GridMesh(const SurfaceGrid& grid);

  const std::vector<Vector3>& samples() const { return samples_; }  ///< world
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// Parameter of a triangle's point on its patch.
  const Vector2& parameter(int point) const { return parameters_[std::size_t(point)]; }

 private:
  void share_nodes(const SurfaceGrid& grid);
  void share_seams(const SurfaceGrid& grid);

  std::vector<Vector3> samples_;
  std::vector<Triangle> triangles_;
  std::vector<Vector2> parameters_;  ///< those of the pattern, then those of points added to sides
};

}  // namespace hariko
