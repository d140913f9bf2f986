#pragma once

// The bridges of a network.

#include <span>
#include <vector>

#include "core/envelope/curve_network.hpp"
#include "core/envelope/envelope_bridge.hpp"

namespace hariko {

/// One for each curve that joins two solids without a valley between them. `waists`: the designer's factors.
std::vector<EnvelopeBridge> bridges_of(const CurveNetwork& network, std::span<const PlacedSolid> solids,
                                       const FlatMap<SolidPair, double>& waists);

}  // namespace hariko
