#pragma once

// Networks that follow the notches between solids: the ladder of attempts (spec 3.1b and 3.7).

#include <optional>

#include "core/envelope/enclosure.hpp"

namespace hariko {

/// What an attempt is made with.
struct ValleyAttempt {
  int level = 0;       ///< of the ladder, 0: the tightness that was asked for
  double slide = 0.5;  ///< of the patches, see `cross_coefficients`
  friend bool operator==(const ValleyAttempt&, const ValleyAttempt&) = default;
};

struct ValleyEnvelope {
  EnclosedNetwork found;
  ValleyAttempt attempt;
  std::size_t folds = 0;
};

inline constexpr int valley_levels = 4;

/// The first attempt that contains the solids and has no fold; none where there is none below `levels`. What
/// folds is tried again with patches that do not slide. `settings` are those of the filled hull.
/// `placed`: relative to `origin`.
std::optional<ValleyEnvelope> valley_envelope(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                                              const Vector3& origin, const EnclosureSettings& settings,
                                              int levels, const CancelToken& cancel = {});

/// One attempt, whatever becomes of it, that starts from the state of the last frame. No patches where the
/// faces cannot be cut.
ValleyEnvelope make_attempt(const EnvelopeInput& input, std::span<const PlacedSolid> placed,
                            const Vector3& origin, EnclosureSettings settings, const ValleyAttempt& attempt,
                            GrowthState start, const CancelToken& cancel = {});

}  // namespace hariko
