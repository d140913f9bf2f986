#pragma once

// The signed volume of the closed parts of a mesh.

#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Per component (numbered as by HalfEdgeMesh::face_components): the volume its faces enclose, each face as
/// triangles from its first corner; positive when they face outwards. 0 for open components, and for those
/// that enclose less than 1e-12 of what their faces span (doubled sheets).
std::vector<double> closed_component_volumes(const HalfEdgeMesh& topology,
                                             std::span<const Vector3> positions);

}  // namespace hariko
