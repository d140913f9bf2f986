#pragma once

// CurveNetwork: rational cubic curves over a cage, the division of faces that are not quads, and the patches
// between the curves (docs/envelope.md).

#include "core/envelope/network/envelope_patch.hpp"
#include "core/envelope/network/hull_cage.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Curve over an edge of the cage.
struct NetworkCurve {
  Index low = 0, high = 0;  ///< vertices, low < high; the curve runs from low to high
  bool primitive = false;   ///< both ends belong to one solid
  bool matched = false;     ///< the weights give the vertices' common curvatures
  RibbonCurve ribbon;       ///< as seen from the face to the left
};

/// Star of quads in an n-gon: a centre, and a curve to it from the midpoint of each side.
struct FaceSplit {
  Vector3 centre = Vector3::Zero(), normal = Vector3::UnitZ();
  std::vector<RibbonCurve> spokes;  ///< from the midpoint of side k to the centre
};

/// Makes the star of a face (Ogasawara and Kobori, section 4). `loop`: the sides, each with the face to its
/// left. `solid`: the solid whose primitive part the face is, or null.
FaceSplit split_face(std::span<const RibbonCurve> loop, const NetworkSolid* solid);

/// Loops of the quads, one per side: from its start to its midpoint, to the centre, to the midpoint of the
/// previous side, and back.
std::vector<std::array<RibbonCurve, 4>> split_loops(std::span<const RibbonCurve> loop,
                                                    const FaceSplit& split);

/// Curves and patches over a cage.
struct CurveNetwork {
  NetworkCage cage;
  std::vector<Index> owners;         ///< index of the authored solid for each of the cage's solids
  std::vector<NetworkCurve> curves;  ///< ascending in (low, high)
  std::vector<std::optional<FaceSplit>> splits;  ///< one per face, nothing for quads
  std::vector<EnvelopePatch> patches;
  struct Place {
    Index face, side;
  };
  std::vector<Place> patch_places;  ///< one per patch; side of the face for n-gons

  /// Index of the curve between two vertices; no_index if there is none.
  Index find(Index a, Index b) const;
  /// Curve from a to b with the face to the left.
  RibbonCurve ribbon(Index a, Index b) const;
};

/// Makes curves and patches over a cage of these solids.
CurveNetwork curve_network(NetworkCage cage, std::span<const NetworkSolid> solids);

/// Whether every curve and every star has a mirror image in the plane through the origin perpendicular to the
/// axis, to within a length. O(vertices^2).
bool is_symmetric(const CurveNetwork& network, Eigen::Index axis, double tolerance);

/// Makes a surface of all patches and their seams, relative to `origin`. Where some face is divided, quads
/// are cut into four parts, so that every seam is a whole side of both patches. Provenance: the cage's faces;
/// seams name the cage's edges by vertex indices.
Surface network_surface(const CurveNetwork& network, const Vector3& origin);

/// Number of patches with a normal opposite to the blend of their corners' normals, at sampled points.
std::size_t folded_patches(const Surface& surface);

}  // namespace hariko
