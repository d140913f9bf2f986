#pragma once

// SurfaceSystem: the linear systems of a polyhedron's surface for one connectivity, shaping and mode; and the
// step from a solved network to patches.

#include <memory>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/g2/g2_system.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/fair/fair_system.hpp"
#include "core/patching/joins/join_plan.hpp"
#include "core/patching/quartic/patch_constants.hpp"

namespace hariko {

/// Systems of a polyhedron's surface.
struct SurfaceSystem {
  std::shared_ptr<const HalfEdgeMesh> mesh;
  NetworkSystem network;
  PatchConstants constants;
  Mode mode = Mode::fair;
  std::unique_ptr<FairSystem> fair;        ///< mode FAIR, and mode G2 where its reference is needed
  std::unique_ptr<G2System> g2 = nullptr;  ///< mode G2 only
  /// Flags per half-edge: the inner points that serve it are given by a join; empty when there is none.
  std::vector<bool> given_side = {};
  std::vector<Index> rims = {};  ///< mode FAIR: the clamped rims (`clamped_boundary_edges`)
};

/// Region in which patches are built: faces, and the vertices whose rings are solved in modes PAPER and
/// TARGET.
struct PatchRegion {
  std::span<const Index> faces, vertices;
};

/// Builds the control points of the patches of a region over its network; those of other faces are left as
/// they are (zero, for the response to a displacement). `joins`: points given by joins; `rims`: border
/// half-edges that bend as `rim_bend` says; both absent for the response to a displacement, which they do not
/// affect. With a FairSystem these are the patches of mode FAIR, whatever the mode, and the result is its
/// solution; otherwise the result is empty.
FairSystem::Solution build_patches(const SurfaceSystem& system, std::span<const Vector3> positions,
                                   const Network& network, const PatchRegion& region,
                                   const FairSystem::SolveOptions& options, const CancelToken& cancel,
                                   std::span<QuarticPatch> patches, const JoinGeometry& joins = {},
                                   std::span<const Index> rims = {});

}  // namespace hariko
