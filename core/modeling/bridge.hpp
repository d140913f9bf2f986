#pragma once

// Bridges: strips of faces between two faces, two borders, or two stretches of border.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/modeled.hpp"

namespace hariko {

struct BridgeOptions {
  /// Turns the second end on by so many corners from the best alignment (closed bridges only).
  int twist = 0;
};

/// Ends with more vertices than this are not bridged.
inline constexpr std::size_t largest_bridge_end = 2000;

// The strip has quads, and triangles where one end has more edges than the other; of all such strips it takes
// the one whose cross edges are shortest in sum. Selects the new faces. Errors of all: E_NOTHING_SELECTED,
// E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (not two ends, ends that touch, edges not on a border),
// E_WOULD_BE_NONMANIFOLD (an edge runs already where the strip would have one), E_TOO_MANY_ELEMENTS.

/// A tunnel, or a handle, between two faces, which go. The Euler number falls by 2.
Result<Modeled> bridge_faces(const PolyhedronSource& source, FaceId first, FaceId second,
                             const BridgeOptions& options = {});

/// Between the two closed borders, or the two open stretches of border, that the edges form. The Euler number
/// stays for closed borders and falls by 1 for stretches.
Result<Modeled> bridge_borders(const PolyhedronSource& source, std::span<const EdgeId> edges,
                               const BridgeOptions& options = {});

}  // namespace hariko
