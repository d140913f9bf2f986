#pragma once

// Which of the constructions a scene's surface is made by (docs/envelope.md, spec 16.10).

#include <span>

#include "core/envelope/placed_solid.hpp"

namespace hariko {

/// What the surface is made on.
enum class EnvelopeRoute : std::uint8_t {
  hull,     ///< the network of the filled hull
  valleys,  ///< the hull's network, sunk into the notches
  field,    ///< a field's cage
  ball      ///< patches on what a rolling ball leaves
};

/// The designer's choice, or the automatic one: valleys for up to three solids, a field's cage for holes,
/// separate parts and more of them.
EnvelopeRoute envelope_route(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                             const Vector3& origin);

}  // namespace hariko
