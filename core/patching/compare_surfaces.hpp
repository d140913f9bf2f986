#pragma once

// Comparison of two surfaces: the patches they have in common, to the last bit.

#include <cstddef>
#include <optional>

#include "core/surface/surface.hpp"

namespace hariko {

/// Result of a comparison: each patch of the first surface is compared with the patch of the second one that
/// comes from the same side of the same element.
struct SurfaceComparison {
  std::size_t patches = 0;
  std::size_t unchanged = 0;  ///< all control points equal, bit for bit, and the origin too
  std::size_t changed = 0;
  std::size_t unmatched = 0;  ///< no such patch there, or one of another kind
  /// Largest distance between control points of the same number, relative to the diagonal of the first
  /// surface's box of control points. Nothing when no patch has a partner.
  std::optional<double> largest_distance;
};

/// Compares two surfaces. Supports patches of polyhedra in all modes (those of a face in mode G2 share its
/// controls, so they change together) and bicubic ones; others count as unmatched. O(patches log patches).
SurfaceComparison compare_surfaces(const Surface& surface, const Surface& other);

}  // namespace hariko
