#pragma once

// Warnings about the shape of a finished surface (kuriyama.md section 5).

#include <vector>

#include "core/base/message.hpp"
#include "core/network/network.hpp"
#include "core/polyhedron/element_aliases.hpp"
#include "core/polyhedron/polyhedron.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Warnings of a surface: W_LONG_TANGENT per edge whose Bezier tangent is longer than the edge (the curve may
/// loop), W_FOLD per face where the normal at a sample point turns by more than 107 degrees from the patch's
/// mean normal. At most 100 of each. Elements are named by `aliases` where given, and copies are not
/// mentioned. O(patches).
std::vector<Message> surface_warnings(const Polyhedron& polyhedron, const Network& network,
                                      const Surface& surface, const ElementAliases* aliases = nullptr);

}  // namespace hariko
