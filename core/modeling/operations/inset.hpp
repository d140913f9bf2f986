#pragma once

// Insetting faces: a band of even width inside the rim of a group of faces.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/selection/region.hpp"

namespace hariko {

struct InsetOptions {
  double amount = 0;
  /// `distance`: the width of the band. `share`: fraction, 0 .. 1 (both excluded), of the width at which the
  /// first edge of a group shrinks to nothing, for each group separately.
  enum class Measure { distance, share } measure = Measure::distance;
  Grouping as = Grouping::region;
};

/// Moves the rim of each group inwards in the planes of its faces, so that new and old rim are the given
/// distance apart, and fills the band with quads. A face of a group that is planar stays planar when its
/// corner at the rim has no other faces of the group, and where the faces fold along an edge that meets the
/// rim at equal angles.
///
/// The faces keep their ids, the old rim its place and shaping. The new rim is plain, no crease
/// (`tighten_short_edges` for narrow bands).
/// An edge of the group that ends at the rim carries its tension and crease across the band. The Euler number
/// stays. Selected afterwards: the faces inside the band.
///
/// Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_BAD_AMOUNT (zero, negative, not finite, or so wide that a
/// face would shrink to nothing or turn over), E_WRONG_SELECTION (a group that is closed).
Result<EditResult> inset_faces(const PolyhedronSource& source, std::span<const FaceId> faces,
                               const InsetOptions& options);

/// Returns the distance at which the first edge of a group shrinks to nothing: `inset_faces` refuses it and
/// all larger ones. Infinity where no edge shrinks. Errors: those of `inset_faces` that concern the
/// selection.
Result<double> largest_inset(const PolyhedronSource& source, std::span<const FaceId> faces, Grouping as);

}  // namespace hariko
