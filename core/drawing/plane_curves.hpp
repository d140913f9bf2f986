#pragma once

// Curves in which a plane cuts a surface, closed wherever the surface is.

#include <Eigen/Geometry>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/drawing/grid_mesh.hpp"
#include "core/drawing/place_lines.hpp"

namespace hariko {

/// Intersection of a surface with a plane in the world, as places of the surface itself; a place on a seam
/// stands once for each of the two patches. `mesh` is the mesh of the grid.
///
/// Samples in the plane count as being above it (a symbolic perturbation), so that every triangle is crossed
/// between two of its edges or not at all, and crossings of triangles with a common edge are one. The curves
/// of a mesh without border are therefore closed wherever the plane lies. Crossings on edges that end in the
/// plane are moved to that end; a curve of which nothing remains but one point is none. A flat part in the
/// plane is bounded once, where the surface goes on below it. Samples lie in the plane within `noise`, a
/// length: the rounding of positions. O(triangles + crossings log crossings).
std::vector<PlaceLine> plane_places(const SurfaceGrid& grid, const GridMesh& mesh,
                                    const Eigen::Hyperplane<double, 3>& plane, double noise,
                                    const CancelToken& cancel);

}  // namespace hariko
