#pragma once

// Rings: the G1 conditions around a point, solved locally (Kuriyama 1991, equations (11), (13); kuriyama.md
// sections 4.3 and 4.4).

#include <span>
#include <vector>

#include "core/network/shaping.hpp"
#include "core/patching/patch_network.hpp"

namespace hariko {

/// Solves the inner points for mode PAPER or TARGET, in the rings around these vertices and around the split
/// points of these faces. `patches` holds base patches (PatchBuilder::base_patch) of all half-edges concerned
/// on entry. `given_side`, per half-edge: the points that serve this border edge stay as they are; empty when
/// there is none.
void solve_rings(const HalfEdgeMesh& mesh, const PatchConstants& constants, Mode mode,
                 std::span<const Index> vertices, std::span<const Index> faces,
                 std::span<QuarticPatch> patches, const std::vector<bool>& given_side);

}  // namespace hariko
