#pragma once

// Which cages with valleys give calm surfaces.

#include "core/envelope/valley_envelope.hpp"

namespace hariko {

/// Faces with three corners, one of which lies in a valley: the surface wrinkles at their tips (spec 15:
/// curvature 131 in a T).
std::size_t valley_tips(const NetworkCage& cage);

/// The first cage of the ladder has none. Much quicker than an attempt.
bool suits_valleys(const EnvelopeInput& input, std::span<const PlacedSolid> placed, const Vector3& origin,
                   EnclosureSettings settings);

}  // namespace hariko
