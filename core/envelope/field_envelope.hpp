#pragma once

// The envelope on a field's cage: the ladder of settings until the surface has no fold and the wanted
// topology.

#include "core/envelope/cage_surface.hpp"
#include "core/envelope/field_cage.hpp"

namespace hariko {

struct FieldEnvelope {
  CageSurface surface;
  int level = 0;  ///< of the ladder, 0: the first settings
  int components = 0, tunnels = 0, wanted_tunnels = 0;
};

/// `placed`: relative to `origin`. Errors: E_ENVELOPE_FLAT where no cage was found, those of `cage_surface`.
Result<FieldEnvelope> field_envelope(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                                     const Vector3& origin, Quality quality, const CancelToken& cancel = {});

}  // namespace hariko
