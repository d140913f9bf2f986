#pragma once

// Sites on the Gauss sphere spread evenly before planes are put on them.

#include "core/gaussmap/sphere_mesh.hpp"

namespace hariko {

/// Lloyd's method: `rounds` times every inner site moves to the centroid of its Voronoi cell and half as far
/// beyond, and edges are flipped until the triangulation is Delaunay again inside the loops, which keep their
/// sites and edges. A site that would turn a triangle over or come too near to a loop stays. Insertion leaves
/// triangles of all shapes between those of an empty circle and half of one; the curves of a network spread
/// their tangents evenly round a vertex and need neighbours that are as even. Expected O(sites) a round.
SphereMesh relaxed(const SphereMesh& mesh, int rounds);

}  // namespace hariko
