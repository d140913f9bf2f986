#pragma once

// Edges far shorter than those beside them: lengths and fan angles at their ends (kuriyama.md section 12.8).

#include <span>
#include <vector>

#include "core/network/face_charts.hpp"

namespace hariko {

/// Length of an edge in its vertex's fan with the given longest edge: kept above zero, but hardly longer than
/// the edge is.
double fan_length(double length, double longest);

/// Steps of the fan of a vertex inside the mesh after alignment beside short edges, from its own steps and
/// those of its neighbours before alignment: at both ends of a far shorter edge the edges beside it look
/// alike. `corners`: those of the fan, counter-clockwise. `own_steps`: per corner of the mesh, 0 around
/// vertices that do not take part. The sum stays the same; not yet limited.
std::vector<double> steps_beside_short_edges(const HalfEdgeMesh& mesh, const FaceCharts& charts,
                                             std::span<const Index> corners,
                                             std::span<const double> own_steps);

}  // namespace hariko
