#pragma once

// SurfaceSystem: what a polyhedron's surface is computed with, for one connectivity, shaping and mode; and
// the step from a solved network to patches.

#include <memory>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/fair_system.hpp"
#include "core/patching/patch_constants.hpp"

namespace hariko {

struct SurfaceSystem {
  std::shared_ptr<const HalfEdgeMesh> mesh;
  NetworkSystem network;
  PatchConstants constants;
  Mode mode = Mode::fair;
  std::unique_ptr<FairSystem> fair;  ///< mode FAIR only
};

/// Where patches are wanted: faces, and the vertices whose rings are solved in modes PAPER and TARGET.
struct PatchRegion {
  std::span<const Index> faces, vertices;
};

/// Control points of the patches of a region over its network; those of other faces are left as they are
/// (zero, for the response to a displacement). The result is what mode FAIR solved for, empty in the other
/// modes.
FairSystem::Solution build_patches(const SurfaceSystem& system, std::span<const Vector3> positions,
                                   const Network& network, const PatchRegion& region,
                                   const FairSystem::SolveOptions& options, const CancelToken& cancel,
                                   std::span<QuarticPatch> patches);

}  // namespace hariko
