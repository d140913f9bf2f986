#pragma once

// Closed surfaces of square patches that meet along whole sides.

#include <span>

#include "core/surface/surface.hpp"

namespace hariko {

/// Place of a patch in a closed surface: the nodes of its corners, its provenance, and the elements of its
/// sides.
struct ClosedPatch {
  std::array<Index, 4> nodes{};
  Provenance provenance = {};
  std::array<Element, 4> sources{};
};

/// Makes the surface: two sides between the same nodes, in opposite directions, are a seam, which has the
/// element that its second side names. Every side is one of such a pair (asserted). `normals`: one per node.
/// O(n), where no node has many sides.
Surface closed_surface(const Vector3& origin, std::shared_ptr<const PatchSet> patches,
                       std::span<const ClosedPatch> places, std::vector<Vector3> normals);

}  // namespace hariko
