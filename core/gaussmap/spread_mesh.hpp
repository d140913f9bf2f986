#pragma once

// Inner vertices of a mesh in space spread evenly, for the mode position. Internal to core/gaussmap.

#include "core/gaussmap/position_mesh.hpp"

namespace hariko {

/// Lloyd's method as in `relaxed`, on the mesh as it lies: `rounds` times every inner vertex moves within its
/// tangent plane to the middle of its Voronoi cell and half as far beyond, and edges are flipped whose
/// opposite angles add up to more than a half turn. The loops keep their vertices and edges, and each of
/// their vertices an edge inside. A vertex that would turn a triangle over or come too near to a loop stays.
/// Moves leave a curved surface by the square of their length: what follows has to put them back. Expected
/// O(vertices) a round.
void spread_evenly(PositionMesh& mesh, int rounds);

}  // namespace hariko
