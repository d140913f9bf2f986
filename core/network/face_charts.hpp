#pragma once

// Face charts: every face as a polygon in the plane, round its split point. Angles and areas of the network
// and of the patches come from here (kuriyama.md section 12.1).

#include <vector>

#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Corner j of a face lies at p_j, counter-clockwise round 0. Patch h is the triangle (0, p of origin(h), p
/// of target(h)).
struct FaceCharts {
  Frames frames = Frames::equal;
  std::vector<Vector2> corner;  ///< per half-edge: p of its origin
  std::vector<double> square;   ///< per half-edge: p . p of its origin
  std::vector<double> dot;      ///< per half-edge: p of its origin . p of its target
  /// Per half-edge: x, the area of its patch, > 0. Equal frames: 1 / (4 sin^2(pi / n)), since only ratios
  /// count, and p on the unit circle.
  std::vector<double> area;
  /// Frames by measure only: lengths in space per edge, their mean (1 where all are zero), and per half-edge
  /// the distance of its origin from the mean of the face's vertices.
  std::vector<double> edge_length;
  double mean_length = 0;
  std::vector<double> ray_length;
};

/// 1 / (4 sin^2(pi / n)): the factor of split tangents in a regular n-gon.
double split_factor(Index sides);

/// Regular polygons, whatever the positions.
FaceCharts equal_charts(const HalfEdgeMesh& mesh);

/// Continuous in the positions; the same up to a turn of the plane for any rotation, and scaled as the
/// polyhedron is. Faces with a corner in `half_turn` (per half-edge) get the regular polygon of the same
/// area. `side_share`: per half-edge, where its origin lies between the corners before and behind it, on a
/// straight side of the face's chart whatever its position says; 0 for corners of the chart's polygon; may be
/// empty.
FaceCharts metric_charts(const Polyhedron& polyhedron, const std::vector<bool>& half_turn,
                         std::span<const double> side_share = {});

}  // namespace hariko
