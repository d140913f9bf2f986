#pragma once

// Even distribution of sites on the Gauss sphere before tangent planes are computed.

#include "core/gaussmap/sphere/spherical_delaunay.hpp"

namespace hariko {

/// Over-relaxed Lloyd's method: in each of `rounds` rounds every inner site moves to the centroid of its
/// Voronoi cell and half as far beyond, and edges are flipped until the triangulation is Delaunay again
/// inside the loops, which keep their sites and edges. A site that would invert a triangle or come too near
/// to a loop stays. Insertion leaves empty circles between half the largest radius and the full one, so that
/// triangles are uneven; the curve network distributes its tangents evenly round a vertex and needs even
/// neighbours. Expected O(sites) per round.
SphereMesh relaxed(const SphereMesh& mesh, int rounds);

}  // namespace hariko
