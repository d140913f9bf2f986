#pragma once

// Joining of coincident corners along the edges of faces, for meshes in which every face has its own
// vertices.

#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Joins vertices at bit-identical positions (0 and -0 are equal) where exactly two unmatched sides of faces
/// coincide; the lowest number of the joined vertices represents them. Positions stay unchanged, unused
/// vertices included. Where more than two sides coincide nothing is joined, so that touching solids stay
/// separate, nor where both faces run in one direction, so that one-sided strips stay cut where they are.
/// Returns the number of vertices that were replaced. O(sides log sides).
std::size_t join_equal_corners(PolygonMesh& mesh);

}  // namespace hariko
