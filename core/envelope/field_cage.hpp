#pragma once

// Cages contoured from a rounded union of distances: any number of solids, holes and separate parts
// (docs/envelope.md, spec 16).

#include <optional>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/envelope/field_grid.hpp"
#include "core/envelope/placed_solid.hpp"
#include "core/envelope/solid_distance.hpp"

namespace hariko {

/// A round bar through the gap between two solids.
struct FieldBar {
  SolidPair solids;                  ///< ids
  Vector3 middle = Vector3::Zero();  ///< of what can be seen of it
  Vector3 axis = Vector3::UnitZ();   ///< unit
  double radius = 0;
  SolidDistance distance;
};

/// Solids that make one part of the surface, with the bars that bridge their gaps.
struct FieldCluster {
  std::vector<Index> solids;
  std::vector<FieldBar> bars;
};

struct FieldScene {
  std::vector<SolidDistance> distances;      ///< one a solid of the input
  std::vector<std::vector<Vector3>> points;  ///< test points of each
  double diagonal = 1;
  std::vector<FieldCluster> clusters;
  /// Of solids that touch, by their numbers: how wide the fillet in their notch is to be. Below 1 it is so
  /// much of what the settings of the cage say, 2 adds `slack_fillet`.
  UnionField::Factors fillets;
  std::optional<Eigen::Index> symmetry = {};  ///< axis across the plane through zero that halves the scene
};

/// `placed`: as `place_solids` gives them, relative to `origin`. Gaps of at most 1.5 times the thinner solid
/// are bridged.
FieldScene field_scene(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                       const Vector3& origin);

/// Of the cell: what the lowest tightness adds to fillets, and the largest waist.
inline constexpr double slack_fillet = 2;

struct FieldCageSettings {
  double fillet = 0.5;     ///< over the cell
  double crispness = 0.7;  ///< how firmly vertices stay on edges and corners of the solids
  double detail = 1;
  double budget = 400;
};

struct FieldCage {
  std::vector<Vector3> positions;
  std::vector<std::array<Index, 4>> quads;
  std::vector<double> cell;  ///< one a vertex
  int components = 0, tunnels = 0, wanted_tunnels = 0;
  std::vector<GridChoice> grids;  ///< one a cluster
};

/// What the grids of each cluster are measured by. The same for all settings.
std::vector<GridReference> grid_references(const FieldScene& scene);

/// Holes through the solids with their bridges.
int tunnels_of(const FieldScene& scene);

/// `references`: those of the scene. Empty where a cluster is met by no grid. `known`: the grids of the same
/// clusters a moment ago, which serve again where they can; or none.
FieldCage field_cage(const FieldScene& scene, std::span<const GridReference> references,
                     const FieldCageSettings& settings, const CancelToken& cancel = {},
                     std::span<const GridChoice> known = {});

}  // namespace hariko
