#pragma once

// Measures of faces and edges in the energy of mode G2 (g2.md section 5).

#include "core/g2/face_energy.hpp"
#include "core/network/face_charts.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// The regular polygon in equal frames; by measure, the affine image of it that the face's chart comes
/// nearest to. `first`: corner of the face that is the chart's first.
ChartMeasure face_measure(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index face, Index first);
/// Weight of an edge's terms beside those of faces.
double edge_measure(const FaceCharts& charts, Index edge);

}  // namespace hariko
