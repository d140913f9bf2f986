#pragma once

// Surfaces of mode G2 from a solved network, and their response to a drag.

#include <memory>
#include <vector>

#include "core/g2/g2_patch_set.hpp"
#include "core/patching/fair/influence_region.hpp"
#include "core/patching/surface_system.hpp"

namespace hariko {

/// Reference surface of mode FAIR, from which target curvatures are taken.
ReferencePatches reference_patches(const QuarticPatchArray& patches);

/// Patches of mode G2: the controls of all faces from a solution.
std::shared_ptr<const G2PatchSet> g2_patches(const G2System& system, const G2System::Given& given,
                                             const G2System::Field& unknowns);

/// Response of the controls of faces to a common displacement of some vertices, each of which may follow in
/// part.
struct G2DragResponse {
  std::vector<Index> moved;                ///< ascending
  std::vector<double> weight;              ///< share of the displacement that each of them makes
  std::vector<Index> faces;                ///< affected faces, ascending
  std::vector<std::vector<double>> share;  ///< per face: the share of each of its controls
  std::vector<double> largest;             ///< per face: largest share
  bool settled = false;                    ///< as in `DragResponse`

  LocalDrag local;
  std::shared_ptr<const G2System::Paused> paused;  ///< state from which `refine` continues
};

/// Solves the response to a displacement. Requires `!system.network.couples_coordinates()`. Solves within the
/// rings of faces that matter, with the matrix as it is: where it measures bending over a reference, the
/// reference stays fixed, as do target curvatures. Takes a few steps only; `refine` takes as many more.
G2DragResponse g2_drag_response(const SurfaceSystem& system, std::vector<Index> moved,
                                std::vector<double> weight, const CancelToken& cancel = {});
/// Continues a response that is not settled by a few steps.
void refine(const SurfaceSystem& system, G2DragResponse& response, const CancelToken& cancel = {});

/// Displaced patches: base + share * displacement in the faces that move by more than `negligible` (a
/// length); `changed` gets their patches, ascending.
std::shared_ptr<const G2PatchSet> displaced(const HalfEdgeMesh& mesh, const G2PatchSet& base,
                                            const G2DragResponse& response, const Vector3& displacement,
                                            double negligible, std::vector<Index>& changed);

}  // namespace hariko
