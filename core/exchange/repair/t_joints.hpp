#pragma once

// T-joints: corners of faces that lie on an edge of another face, which leave a slit without width. Internal
// to core/exchange.

#include <vector>

#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Edge of one face whose other side is several edges of others.
struct TJoint {
  Index corner;                ///< starts the edge in the list of corners
  std::vector<Index> between;  ///< vertices on it, in the direction of its face
};

/// T-joints between borders: vertices at most `distance` from an edge, a length >= 0, whose border edges run
/// back along all of it. O(border log border) expected.
std::vector<TJoint> find_t_joints(const PolygonMesh& mesh, double distance);

/// Mesh with the vertices of T-joints as corners of the faces whose edge they lie on; such triangles are
/// divided. O(corners log corners).
PolygonMesh with_split_edges(const PolygonMesh& mesh, const std::vector<TJoint>& joints);

}  // namespace hariko
