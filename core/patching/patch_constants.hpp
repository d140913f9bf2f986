#pragma once

// The constants of the G1 conditions: functions of connectivity and tags alone (kuriyama.md section 4.2).

#include <vector>

#include "core/network/vertex_frames.hpp"

namespace hariko {

/// Patch h lies at half-edge h: corners O (the face's split point), origin(h), target(h). The split edge of
/// corner h joins O and origin(h).
struct PatchConstants {
  std::vector<double> f;         ///< per face: 1 / (4 sin^2(pi / n))
  std::vector<double> c_centre;  ///< per face: c of its split edges at O
  std::vector<double> c_split;   ///< per half-edge: c of the corner's split edge at the vertex
  std::vector<bool> free_split;  ///< per half-edge: the corner spans a half turn, its split tangent is free
  std::vector<bool> smooth;      ///< per half-edge: G1 is asked for across its edge
  std::vector<double> c_origin, c_target;  ///< per half-edge: c of its edge at both ends (0 on sharp edges)
  std::vector<double>
      own;  ///< per half-edge: weight of the own face's point in the condition (0 on sharp edges)
};

PatchConstants patch_constants(const HalfEdgeMesh& mesh, const VertexFrames& frames);

/// 1 / (4 sin^2(pi / n)): the factor of split tangents in an n-sided face.
double split_factor(Index sides);

}  // namespace hariko
