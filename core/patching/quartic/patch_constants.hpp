#pragma once

// Patch constants: the constants of the G1 conditions, functions of the frames alone (kuriyama.md sections
// 4.2 and 12.3).

#include <vector>

#include "core/network/vertex_frames.hpp"

namespace hariko {

/// Constants of the G1 conditions, all per half-edge. Patch h lies at half-edge h: corners O (the face's
/// split point), origin(h), target(h). The split edge of corner h joins O and origin(h); patch h lies on its
/// left, seen from O.
struct PatchConstants {
  std::vector<double> x;          ///< area of the patch in its face's chart, up to a common factor
  std::vector<double> c_centre;   ///< c of the corner's split edge at O
  std::vector<double> c_split;    ///< c of the corner's split edge at the vertex
  std::vector<double> own_split;  ///< weight of patch h's point in the condition of its first split edge
  std::vector<bool> free_split;   ///< true where the corner spans a half turn: its split tangent is free
  std::vector<bool> smooth;       ///< true where G1 is required across its edge
  std::vector<double> c_origin, c_target;  ///< c of its edge at both ends (0 on sharp edges)
  std::vector<double> own;  ///< weight of the point of the own face in the condition (0 on sharp edges)
};

/// Computes the constants from the frames. O(half-edges).
PatchConstants patch_constants(const HalfEdgeMesh& mesh, const VertexFrames& frames);

}  // namespace hariko
