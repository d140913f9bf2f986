#pragma once

// The handles of a network.

#include <span>

#include "core/envelope/curve_network.hpp"
#include "core/envelope/envelope_handles.hpp"

namespace hariko {

/// Bridges are the curves that join two solids without a valley between them. `settings`: those that the
/// network was made with. O(network).
EnvelopeHandles handles_of(const CurveNetwork& network, std::span<const PlacedSolid> solids,
                           const EnvelopeSettings& settings);

}  // namespace hariko
