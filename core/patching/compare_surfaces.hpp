#pragma once

// Which patches two surfaces have in common, to the last bit.

#include <cstddef>
#include <optional>

#include "core/surface/surface.hpp"

namespace hariko {

/// Patches of the first surface, each compared with the patch of the second one that comes from the same side
/// of the same element.
struct SurfaceComparison {
  std::size_t patches = 0;
  std::size_t unchanged = 0;  ///< all control points equal, bit for bit, and the origin too
  std::size_t changed = 0;
  std::size_t unmatched = 0;  ///< no such patch there, or one of another kind
  /// Between control points of the same number, over the diagonal of the first surface's box of control
  /// points. Empty when no patch has a partner.
  std::optional<double> largest_distance;
};

/// For patches of polyhedra in all modes (those of a face in mode G2 share its controls, so they change
/// together) and bicubic ones; others count as unmatched. O(patches log patches).
SurfaceComparison compare_surfaces(const Surface& surface, const Surface& other);

}  // namespace hariko
