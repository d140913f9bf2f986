#pragma once

// Signed volumes of the closed parts of a mesh.

#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Volume that each component encloses (numbered as by HalfEdgeMesh::face_components), each face as triangles
/// from its first corner; positive when the faces point outwards. 0 for open components, and for those that
/// enclose less than 1e-12 of the volume that their faces span (doubled sheets).
std::vector<double> closed_component_volumes(const HalfEdgeMesh& topology,
                                             std::span<const Vector3> positions);

}  // namespace hariko
