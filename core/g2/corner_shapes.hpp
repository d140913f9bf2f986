#pragma once

// Corner shapes: the corners of faces as the vertices' frames have them (g2.md section 3).

#include <vector>

#include "core/g2/face_chart.hpp"
#include "core/network/vertex_frames.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Per half-edge: the corner at its origin. Lengths are relative to the mean edge of the vertex's fan. Equal
/// frames have unit lengths and the corner's sine across.
std::vector<CornerShape> corner_shapes(const HalfEdgeMesh& mesh, const VertexFrames& frames);

/// Per vertex: the mean edge of its fan, which stands for one in its chart.
std::vector<double> fan_units(const HalfEdgeMesh& mesh, const VertexFrames& frames);

}  // namespace hariko
