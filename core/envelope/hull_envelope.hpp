#pragma once

// Networks round the filled hull: the ladder of settings where the designer's own fold or do not enclose.

#include "core/envelope/enclosure.hpp"

namespace hariko {

/// What an attempt changes of the settings.
struct HullAttempt {
  double more_detail = 0;  ///< added to the thinning distance
  double waist = 1;        ///< factor
  bool paired = true;      ///< neighbouring triangles become quads
  /// Further factors on the waists of bridges, placed solids low, high.
  std::map<std::pair<Index, Index>, double> waists;
};

/// As bad as so many folded patches is a point of a solid outside.
inline constexpr double outside_folds = 3;

struct HullEnvelope {
  EnclosedNetwork found;
  HullAttempt attempt;
  std::size_t folds = 0;
};

/// The first attempt that contains the solids and has no fold; where none has, that with the fewest folds and
/// the least miss. Tauter bridges where patches fold come first, since they leave the rest as it was.
/// No patches where the solids are too flat. At most 30 searches.
HullEnvelope hull_envelope(std::span<const PlacedSolid> solids, const EnclosureSettings& settings,
                           const CancelToken& cancel = {});

/// One attempt, whatever becomes of it, that starts from the state of the last frame.
HullEnvelope make_attempt(std::span<const PlacedSolid> solids, EnclosureSettings settings,
                          const HullAttempt& attempt, GrowthState start, const CancelToken& cancel = {});

}  // namespace hariko
