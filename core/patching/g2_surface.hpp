#pragma once

// Surfaces of mode G2 from a solved network, and their answer to a drag.

#include <memory>
#include <vector>

#include "core/g2/g2_patch_set.hpp"
#include "core/patching/drag_region.hpp"
#include "core/patching/surface_system.hpp"

namespace hariko {

/// A surface of mode FAIR, to take curvature from.
ReferencePatches reference_patches(const QuarticPatchArray& patches);

/// Controls of all faces.
std::shared_ptr<const G2PatchSet> g2_patches(const G2System& system, const G2System::Given& given,
                                             const G2System::Field& unknowns);

/// How the controls of faces answer a common displacement of some vertices, of which each may follow in part.
struct G2DragResponse {
  std::vector<Index> moved;                ///< ascending
  std::vector<double> weight;              ///< share of the displacement that each of them makes
  std::vector<Index> faces;                ///< that feel it, ascending
  std::vector<std::vector<double>> share;  ///< per face: of each of its controls
  std::vector<double> largest;             ///< per face: largest share
  bool settled = false;                    ///< as in `DragResponse`

  LocalDrag local;
  std::shared_ptr<const G2System::Paused> paused;  ///< where `refine` goes on
};

/// Requires `!system.network.couples_coordinates()`. Solves within the rings of faces that matter, with the
/// matrix as it is: where it measures bending over a reference, that stays frozen, as do target curvatures.
/// Takes some steps only; `refine` takes as many more.
G2DragResponse g2_drag_response(const SurfaceSystem& system, std::vector<Index> moved,
                                std::vector<double> weight, const CancelToken& cancel = {});
void refine(const SurfaceSystem& system, G2DragResponse& response, const CancelToken& cancel = {});

/// base + share * displacement in the faces that move by more than `negligible` (a length); `changed` gets
/// their patches, ascending.
std::shared_ptr<const G2PatchSet> displaced(const HalfEdgeMesh& mesh, const G2PatchSet& base,
                                            const G2DragResponse& response, const Vector3& displacement,
                                            double negligible, std::vector<Index>& changed);

}  // namespace hariko
