#pragma once

// DragResponse: the response of a surface's control points to a common displacement of some vertices, each of
// which may follow in part (soft selection). The whole construction is linear in positions, so one solve at
// the start of a drag replaces all solves during it.

#include <array>
#include <memory>
#include <vector>

#include "core/patching/fair/influence_region.hpp"
#include "core/patching/quartic/quartic_patch.hpp"
#include "core/patching/surface_system.hpp"

namespace hariko {

/// Response of the patches' control points to a displacement, and the state from which `refine` continues.
struct DragResponse {
  std::vector<Index> moved;    ///< vertices that move together, ascending
  std::vector<double> weight;  ///< share of the displacement that each of them makes
  /// Patches affected by the displacement, ascending, the share of each of their control points, and the
  /// largest share of each.
  std::vector<Index> patches;
  std::vector<std::array<double, quartic_control_count>> share;
  std::vector<double> largest;
  /// Whether the response is solved completely. Before that, shares are accurate to about 1e-4, and the
  /// surface is smooth all the same.
  bool settled = false;

  LocalDrag local;
  FairSystem::Field unknowns;  ///< solution so far
};

/// Solves the response to a displacement of `moved`. Requires `!system.network.couples_coordinates()`: x, y
/// and z must not depend on each other. Solves within the rings of faces that matter, as the influence of a
/// vertex fades by about 0.27 per ring. In mode FAIR it takes a few steps only, so that the first frame of a
/// drag does not wait; `refine` takes as many more.
DragResponse drag_response(const SurfaceSystem& system, std::vector<Index> moved, std::vector<double> weight,
                           const CancelToken& cancel = {});
/// Continues a response that is not settled by a few steps. Nothing changes where cancelled.
void refine(const SurfaceSystem& system, DragResponse& response, const CancelToken& cancel = {});

/// Displaced patches: base + share * displacement in the patches that move by more than `negligible` (a
/// length), copying only changed patches; `changed` gets their numbers, ascending.
QuarticPatchArray displaced(const QuarticPatchArray& base, const DragResponse& response,
                            const Vector3& displacement, double negligible, std::vector<Index>& changed);

}  // namespace hariko
