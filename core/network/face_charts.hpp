#pragma once

// Face charts: every face as a polygon in the plane, around its split point. They give the angles and areas
// of the network and of the patches (kuriyama.md section 12.1).

#include <vector>

#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Charts of all faces. Corner j of a face lies at p_j, counter-clockwise around 0, the split point. Patch h
/// is the triangle (0, p of origin(h), p of target(h)).
struct FaceCharts {
  Frames frames = Frames::equal;
  std::vector<Vector2> corner;  ///< per half-edge: p of its origin
  std::vector<double> square;   ///< per half-edge: p . p of its origin
  std::vector<double> dot;      ///< per half-edge: p of its origin . p of its target
  /// Area x > 0 of the patch, per half-edge. In equal frames 1 / (4 sin^2(pi / n)) with p on the unit circle,
  /// since only ratios count.
  std::vector<double> area;
  /// Lengths in space, in metric frames only: per edge, their mean (1 where all are zero), and per half-edge
  /// the distance of its origin from the mean of the face's vertices.
  std::vector<double> edge_length;
  double mean_length = 0;
  std::vector<double> ray_length;
};

/// Factor of split tangents in a regular n-gon: 1 / (4 sin^2(pi / n)).
double split_factor(Index sides);

/// Charts of equal frames: regular polygons, whatever the positions.
FaceCharts equal_charts(const HalfEdgeMesh& mesh);

/// Charts of metric frames, from the positions. Continuous in the positions; invariant under rotation but for
/// a rotation of the chart's plane, and scaled with the polyhedron. Faces with a corner in `half_turn` (per
/// half-edge) get the regular polygon of the same area. `side_share`, per half-edge: where its origin lies
/// between the corners before and behind it, on a straight side of the face's chart whatever its position; 0
/// for corners of the chart's polygon; may be empty.
FaceCharts metric_charts(const Polyhedron& polyhedron, const std::vector<bool>& half_turn,
                         std::span<const double> side_share = {});

}  // namespace hariko
