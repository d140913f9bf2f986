#pragma once

// Does a network of patches contain the solids? The search's own measure (spec 6), and the growth that makes
// it.

#include <map>
#include <optional>
#include <set>

#include "core/base/cancellation.hpp"
#include "core/envelope/curve_network.hpp"
#include "core/envelope/enclosure_check.hpp"
#include "core/envelope/valley_cage.hpp"

namespace hariko {

/// What the search changes until the surface contains the solids. Kept for the next frame while dragging.
struct GrowthState {
  std::vector<double> sigma;  ///< >= 1, one a placed solid
  std::map<std::pair<Index, Index>, double>
      cuts;                         ///< factors on the waists of bridges, placed solids low, high
  std::set<SolidVertex> pinned;     ///< vertices that are never thinned
  std::set<SolidVertex> kept;       ///< those of the last network
  std::map<Index, Vector3> pushes;  ///< of valley vertices by their names
  std::set<SolidVertex> stars;      ///< corners that were put into faces with valleys
};

/// Asks for a network that is sunk into the notches.
struct ValleyRequest {
  ValleySettings settings;
  const GrownSolids* solids = nullptr;  ///< not grown
};

struct EnclosureSettings {
  double detail = 0.09, merge_angle = 40, waist = 0.5;
  double tolerance = 1e-4;  ///< of the diagonal
  int largest_builds = 20;
  bool fine = true;    ///< test again on 28 x 28 cells a patch when 14 x 14 are clean
  bool strict = true;  ///< then the independent check, and growth where it finds points outside
  const std::map<std::pair<Index, Index>, double>* waists =
      nullptr;  ///< the designer's factors, placed solids
  const FlatMap<NetworkEdgeKey, double>* fullness = nullptr;
  const FlatMap<NetworkVertexKey, Vector3>* offsets = nullptr;
  std::optional<ValleyRequest> valleys;  ///< none: the filled hull
  /// Of the solids: the network is its own image then, and where valleys cannot be, there is none.
  const SceneSymmetry* symmetry = nullptr;
};

struct EnclosedNetwork {
  CurveNetwork network;
  GrowthState state;
  double diagonal = 0;
  double worst = 0;  ///< largest violation that the search saw, length
  bool enclosed = false;
  std::optional<EnclosureReport> check;  ///< of the independent check, where that was asked for
  int builds = 0;
};

/// The independent check of a network's surface, as it is reported.
EnclosureReport check_network(const CurveNetwork& network, std::span<const PlacedSolid> solids,
                              double diagonal, const CancelToken& cancel = {});

/// Builds networks with growing solids and tauter bridges until the surface contains the solids, or the
/// number of builds is used up; then the best one. `start` may be empty (cold).
EnclosedNetwork search_enclosure(std::span<const PlacedSolid> solids, const EnclosureSettings& settings,
                                 GrowthState start = {}, const CancelToken& cancel = {});

/// Interior samples of patches whose normal looks away from the face: patch normal . Newell normal of its
/// face, or the blend of the normals at the patch's corners, is negative. Numbers of patches, ascending.
std::vector<Index> folded_patches(const CurveNetwork& network);

}  // namespace hariko
