#pragma once

// Corners that lie at equal places, joined along the edges of faces: for meshes of which every face has
// vertices of its own.

#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Joins vertices at bit for bit equal positions (0 and -0 are equal) where exactly two sides of faces that
/// have no other side yet lie on each other; the lowest number of those joined stands for all. Positions stay
/// as they are, vertices that nothing uses any more included. Places where more than two sides meet stay
/// apart, so that solids that touch do not become one. Returns how many vertices were joined into others.
/// O(sides log sides).
std::size_t join_equal_corners(PolygonMesh& mesh);

}  // namespace hariko
