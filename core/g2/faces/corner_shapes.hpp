#pragma once

// Corner shapes: angles and lengths of the corners of faces, from the vertices' frames (g2.md section 3).

#include <vector>

#include "core/g2/faces/face_chart.hpp"
#include "core/network/vertex_frames.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Shape of the corner at the origin of each half-edge. Lengths are relative to the mean edge of the vertex's
/// fan. In equal frames lengths are 1, and the distance across is the sine of the corner.
std::vector<CornerShape> corner_shapes(const HalfEdgeMesh& mesh, const VertexFrames& frames);

/// Mean edge of each vertex's fan, the unit of length in the vertex's chart.
std::vector<double> fan_units(const HalfEdgeMesh& mesh, const VertexFrames& frames);

}  // namespace hariko
