#pragma once

// The hull's cage sunk into the notches between solids (docs/envelope.md, spec 3.1b).

#include <map>
#include <set>

#include "core/envelope/network_cage.hpp"
#include "core/envelope/valley_path.hpp"

namespace hariko {

struct ValleySettings {
  double tightness = 1;      ///< (0, 1], share of the way down
  double waist = 0.5;        ///< the rest of the way is the fillet's
  double least_sink = 0.07;  ///< of an edge's length: shallower notches stay filled
  double slide = 1;          ///< of the patches, see `cross_coefficients`
};

struct ValleyCageInput {
  std::span<const PlacedSolid> solids;
  std::span<const double> growth;  ///< sigma, one a placed solid
  const GrownSolids* grown = nullptr;
  double diagonal = 1;
  ValleySettings settings;
  const std::map<Index, Vector3>* pushes = nullptr;  ///< by names of valley vertices, added to their places
  const std::set<SolidVertex>* stars = nullptr;      ///< corners of solids that the faces must reach
};

/// Sinks edges between two solids into their notch, and cuts the faces along the valleys. Closed, of genus 0.
/// Faces empty where that cannot be done; the hull itself where nothing sinks.
NetworkCage valley_cage(NetworkCage hull, const ValleyCageInput& input);

}  // namespace hariko
