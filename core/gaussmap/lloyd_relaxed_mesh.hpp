#pragma once

// Even distribution of the inner vertices of a mesh in space, for mode position. Internal to core/gaussmap.

#include "core/gaussmap/position_mesh.hpp"

namespace hariko {

/// Over-relaxed Lloyd's method as in `relaxed`, on the mesh in space: in each of `rounds` rounds every inner
/// vertex moves within its tangent plane to the centroid of its Voronoi cell and half as far beyond, and
/// edges are flipped whose opposite angles add up to more than pi. The loops keep their vertices and edges,
/// and each of their vertices keeps an inner edge. A vertex that would invert a triangle or come too near to
/// a loop stays. Moves leave a curved surface by the square of their length, which later steps have to
/// correct. Expected O(vertices) per round.
void spread_evenly(PositionMesh& mesh, int rounds);

}  // namespace hariko
