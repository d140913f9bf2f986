#pragma once

// Errors of a polygon mesh, each with its element (dense indices).

#include <vector>

#include "core/base/message.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Errors of positions: E_NONFINITE for every vertex with a coordinate that is infinite or not a number.
std::vector<Message> position_errors(const PolygonMesh& mesh, std::size_t limit);

/// Errors of connectivity: E_NO_FACES, E_INDEX_RANGE, E_FACE_TOO_SMALL, E_FACE_REPEATED_VERTEX,
/// E_EDGE_NONMANIFOLD_OR_FLIPPED and E_VERTEX_NONMANIFOLD, in this order. Edges are judged among the faces
/// that are sound by themselves, vertices where all their faces and edges are sound. Empty exactly when
/// HalfEdgeMesh::build succeeds.
std::vector<Message> connectivity_errors(const PolygonMesh& mesh, std::size_t limit);

}  // namespace hariko
