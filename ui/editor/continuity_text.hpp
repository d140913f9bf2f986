#pragma once

// Continuity that a surface reaches, in numbers and in a sentence. Pure.

#include <string>

#include "core/analysis/continuity.hpp"
#include "ui/base/language.hpp"

namespace hariko {

/// Edges of the source count once, with their images in a live mirror; seams inside of faces, which are no
/// edges to a designer, by themselves.
struct ReachedContinuity {
  Continuity smooth = Continuity::g1;  ///< level of most edges that are meant to be smooth: g1 or g2
  std::size_t less = 0;                ///< edges that are meant to be smooth and have less than that
  std::size_t inner_less = 0;          ///< seams inside of faces that have less
  std::size_t creases = 0;             ///< edges that are meant to be sharp
  double largest_kink = 0;             ///< between normals where it is meant to be smooth, radians
  bool joined = false;                 ///< there are edges between patches that are meant to be smooth
};

/// `report` must be of `surface` and not of a cancelled run. O(n log n) in the seams.
ReachedContinuity reached_continuity(const Surface& surface, const ContinuityReport& report,
                                     const ContinuityTolerance& tolerance);

/// "curvature-continuous but for 10 creased edges", "tangent-continuous", "largest kink 3.1°, 2 creased
/// edges"; empty where nothing is joined.
std::string text_of(const ReachedContinuity& reached, const Language& tr);

}  // namespace hariko
