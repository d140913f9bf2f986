#pragma once

// Measures of faces and edges in the energy of mode G2 (g2.md section 5).

#include <span>

#include "core/g2/faces/face_energy.hpp"
#include "core/network/face_charts.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Measure of a face's chart: the chart's polygon in equal frames; in metric frames, its affine image nearest
/// to the face's own chart. `first`: corner of the face that is the polygon's first.
ChartMeasure face_measure(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index face, Index first,
                          std::span<const Vector2> polygon);
/// Weight of an edge's terms relative to those of faces.
double edge_measure(const FaceCharts& charts, Index edge);

}  // namespace hariko
