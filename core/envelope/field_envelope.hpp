#pragma once

// The envelope on a field's cage: the ladder of settings until the surface contains the solids, has no fold
// and has the wanted topology.

#include "core/envelope/cage_surface.hpp"
#include "core/envelope/envelope_handles.hpp"
#include "core/envelope/field_cage.hpp"

namespace hariko {

/// The cage keeps away from the solids and fills narrow notches.
inline constexpr Code w_tightness_loose{"W_TIGHTNESS_LOOSE"};
/// A bridge is nearer to its usual thickness than its waist asks for.
inline constexpr Code w_waist_limited{"W_WAIST_LIMITED"};

struct FieldEnvelope {
  CageSurface surface;
  int level = 0;        ///< of the ladder, 0: the first settings
  double distance = 0;  ///< that the cage keeps from the solids, over the diagonal; narrow notches are filled
  bool enclosed = false;  ///< within the tolerance, by the independent check where there was one
  int components = 0, tunnels = 0, wanted_tunnels = 0;
  std::vector<EnvelopeBridge> bridges = {};  ///< on the bars through gaps
  bool waists_followed = true;  ///< else the surface would fold or miss a solid, or a bar has no ring
  bool sound() const { return enclosed && surface.folds == 0; }
};

/// The first level that is sound and has the wanted topology; else the first sound one that keeps a distance;
/// else the best there is. While dragging the one at `level`. `placed`: relative to `origin`. Errors:
/// E_ENVELOPE_FLAT where no cage was found, those of `cage_surface`.
Result<FieldEnvelope> field_envelope(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                                     const Vector3& origin, Quality quality, int level = 0,
                                     const CancelToken& cancel = {});

}  // namespace hariko
