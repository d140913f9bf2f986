#pragma once

// Edges far shorter than those beside them: lengths and fans of their ends (kuriyama.md section 12.8).

#include <span>
#include <vector>

#include "core/network/face_charts.hpp"

namespace hariko {

/// Length of an edge in its vertex's fan, whose longest edge is given: kept from zero, but hardly longer than
/// the edge is.
double fan_length(double length, double longest);

/// Steps of the fan of a vertex inside the mesh, from its own steps and those of its neighbours before this:
/// both ends of a far shorter edge see the edges beside it alike. `corners`: of the fan, counter-clockwise.
/// `own_steps`: per corner of the mesh, 0 round vertices that do not take part. With the same sum; not yet
/// limited.
std::vector<double> steps_beside_short_edges(const HalfEdgeMesh& mesh, const FaceCharts& charts,
                                             std::span<const Index> corners,
                                             std::span<const double> own_steps);

}  // namespace hariko
