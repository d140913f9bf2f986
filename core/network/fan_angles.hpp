#pragma once

// Fan angles: angles between the edges of a vertex in its plane fan, from the corner angles of the faces
// around it (kuriyama.md section 12.2).

#include <span>
#include <vector>

#include "core/network/face_charts.hpp"

namespace hariko {

/// Angle of each corner in its face's chart, 0 .. 2 pi, per half-edge.
double corner_angle(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index corner);

/// Direction of a flat corner's split edge in the face's chart: its angle from the line that passes the
/// corner, from the vertex before it to the one behind it, as a share of a half turn. A short edge beside the
/// corner hardly matters.
double place_in_corner(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index corner);

/// Flatness of a corner, 0 .. 1: 1 where it is flat in the chart of its face and in the fan, from a step of
/// 170 degrees on; 0 for steps up to 150 degrees and for corners that turn by 10 degrees or more in the
/// chart.
double flat_share(double step, double corner_angle);

/// Steps of a sector with these corner angles, adding up to `total`; not yet limited. `sides`: number of
/// sides of each corner's face. `closed`: the sector surrounds the vertex; then opposite edges of an even
/// number are moved towards one line, and so are the two edges at the rim of a face of many sides. Continuous
/// in the angles.
std::vector<double> fan_steps(std::span<const double> angles, std::span<const Index> sides, double total,
                              bool closed);

/// Limited steps: near the given ones, with the sum `total`, each at least 0.1 degrees and below a half turn.
/// Steps within the limits stay as they are, except for what the others need.
std::vector<double> limited_steps(std::vector<double> steps, std::span<const double> angles, double total);

/// Steps of a sector after its edges were turned by these angles (one more than steps; the last repeats the
/// first in a closed fan), with the same sum and limits.
std::vector<double> turned_steps(std::vector<double> steps, std::span<const double> turns,
                                 std::span<const double> angles, double total);

}  // namespace hariko
