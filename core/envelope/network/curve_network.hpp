#pragma once

// The rational cubic curves over a cage, the split of faces that are not quads, and the patches in between
// (docs/envelope.md).

#include <optional>

#include "core/envelope/network/envelope_patch.hpp"
#include "core/envelope/network/hull_cage.hpp"

namespace hariko {

struct NetworkCurve {
  Index low = 0, high = 0;  ///< vertices, low < high; the curve runs from low to high
  bool primitive = false;   ///< both ends belong to one solid
  bool matched = false;     ///< its weights give the vertices' common curvatures
  RibbonCurve ribbon;       ///< seen from the face to the left
};

/// The star of an n-gon: a centre, and a curve from the middle of each side to it.
struct FaceSplit {
  Vector3 centre = Vector3::Zero(), normal = Vector3::UnitZ();
  std::vector<RibbonCurve> spokes;  ///< from the middle of side k to the centre
};

struct CurveNetwork {
  NetworkCage cage;
  std::vector<Index> owners;                     ///< authored solid of each of the cage's solids
  std::vector<NetworkCurve> curves;              ///< ascending in (low, high)
  std::vector<std::optional<FaceSplit>> splits;  ///< one a face, none for quads
  std::vector<EnvelopePatch> patches;
  struct Place {
    Index face, side;
  };
  std::vector<Place> patch_places;  ///< one a patch; side of the face for n-gons

  /// Number of the curve between two vertices; no_index if there is none.
  Index find(Index a, Index b) const;
  /// The curve from a to b with the face to the left.
  RibbonCurve ribbon(Index a, Index b) const;
};

/// Curves and patches over a cage of these solids.
CurveNetwork curve_network(NetworkCage cage, std::span<const NetworkSolid> solids);

/// Whether every curve and every star has an image in the plane through zero at right angles to the axis, to
/// within a length. O(vertices^2).
bool is_symmetric(const CurveNetwork& network, Eigen::Index axis, double tolerance);

/// All patches and their seams as a surface relative to `origin`. Where some face is split, quads are cut
/// into four parts, so that every seam is a whole side of both patches. Provenance: the cage's faces; seams
/// name the cage's edges by numbers of vertices.
Surface network_surface(const CurveNetwork& network, const Vector3& origin);

/// Patches with a normal that looks away from the blend of its corners' normals, by samples.
std::size_t folded_patches(const Surface& surface);

}  // namespace hariko
