#pragma once

// Bridges: strips of faces between two faces, two borders, or two stretches of a border.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

struct BridgeOptions {
  /// Number of corners by which the second end is rotated from the best alignment (closed bridges only).
  int twist = 0;
};

/// Largest number of vertices of an end that can be bridged.
inline constexpr std::size_t largest_bridge_end = 2000;

// The strip consists of quads, and of triangles where one end has more edges than the other; among all such
// strips the one with the least total length of cross edges is chosen. The new faces are selected. Errors of
// both functions: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (not two ends, ends that touch,
// edges not on a border), E_WOULD_BE_NONMANIFOLD (an edge of the strip exists already), E_TOO_MANY_ELEMENTS.

/// Replaces two faces by a tunnel or a handle between them. The Euler number falls by 2.
Result<EditResult> bridge_faces(const PolyhedronSource& source, FaceId first, FaceId second,
                                const BridgeOptions& options = {});

/// Bridges the two closed borders, or the two open stretches of border, that the edges form. The Euler number
/// stays for closed borders and falls by 1 for stretches.
Result<EditResult> bridge_borders(const PolyhedronSource& source, std::span<const EdgeId> edges,
                                  const BridgeOptions& options = {});

}  // namespace hariko
