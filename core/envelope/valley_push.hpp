#pragma once

// Valley vertices go outwards where the surface cuts into solids (spec 3.1b, enclosure).

#include <map>

#include "core/envelope/curve_network.hpp"
#include "core/envelope/valley_path.hpp"
#include "core/envelope/violations.hpp"

namespace hariko {

/// Adds to `pushes` (by names of valley vertices; lengths) what the violations at faces with valley vertices
/// ask for; the violations of other faces come back. At most 0.03 of the diagonal a call, 0.25 in all.
Violations push_valleys(const CurveNetwork& network, const Violations& found, const GrownSolids& grown,
                        std::span<const PlacedSolid> solids, double diagonal,
                        std::map<Index, Vector3>& pushes);

}  // namespace hariko
