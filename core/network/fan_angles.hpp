#pragma once

// Angles between the edges of a vertex in its plane fan, from the corner angles of the faces round it
// (kuriyama.md section 12.2).

#include <span>
#include <vector>

#include "core/network/face_charts.hpp"

namespace hariko {

/// Angle of each corner in its face's chart, 0 .. 2 pi, per half-edge.
double corner_angle(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index corner);

/// Angle from the way past a flat corner, from the vertex before it to the one behind it, to its split edge
/// in the face's chart, as a share of a half turn. A short edge beside the corner hardly counts.
double place_in_corner(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index corner);

/// 1 for corners that are flat in the fan, from a step of 170 degrees on, and in the chart of their face; 0
/// for steps up to 150 degrees and for corners that turn by 10 degrees or more in the chart.
double flat_share(double step, double corner_angle);

/// The steps of a sector with these corner angles, adding up to `total`; not yet limited. `sides`: of each
/// corner's face. `closed`: all round the vertex, where opposite edges of an even number come near to one
/// line, and so do the two edges at the rim of a face of many sides. Continuous in the angles.
std::vector<double> fan_steps(std::span<const double> angles, std::span<const Index> sides, double total,
                              bool closed);

/// Steps near these with the sum `total`, each at least 0.1 degrees and below a half turn. Those within the
/// limits stay as they are, but for what the others need.
std::vector<double> limited_steps(std::vector<double> steps, std::span<const double> angles, double total);

/// Steps of a sector whose edges are turned by these angles (one more than steps; the last is the first one
/// again all round a vertex), with the same sum and limits.
std::vector<double> turned_steps(std::vector<double> steps, std::span<const double> turns,
                                 std::span<const double> angles, double total);

}  // namespace hariko
