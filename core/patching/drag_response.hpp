#pragma once

// DragResponse: how the control points of a surface answer a common displacement of some vertices, of which
// each may follow in part (soft selection). The whole construction is linear in positions, so one solve at
// the start of a drag replaces all solves during it.

#include <array>
#include <memory>
#include <vector>

#include "core/patching/quartic_patch.hpp"
#include "core/patching/surface_system.hpp"

namespace hariko {

struct DragResponse {
  std::vector<Index> moved;    ///< vertices that move together, ascending
  std::vector<double> weight;  ///< the share of the displacement that each of them makes
  /// Patches that feel the move by more than 2e-7 of it, ascending, and the share of each of their control
  /// points.
  std::shared_ptr<const std::vector<Index>> patches;
  std::vector<std::array<double, quartic_control_count>> share;
};

/// Requires `!system.network.couples_coordinates()`: x, y and z must not depend on each other. Solves within
/// the rings of faces that matter: the influence of a vertex fades by about 0.27 a ring.
DragResponse drag_response(const SurfaceSystem& system, std::vector<Index> moved, std::vector<double> weight,
                           const CancelToken& cancel = {});

/// base + share * displacement, copying only what changes.
QuarticPatchArray displaced(const QuarticPatchArray& base, const DragResponse& response,
                            const Vector3& displacement);

}  // namespace hariko
