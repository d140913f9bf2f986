#pragma once

// Faces of a cage while they are cut and merged: loops with the normal that each had when it was a face of
// the hull.

#include <set>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

struct CageLoop {
  std::vector<Index> corners;  ///< counter-clockwise seen from outside
  Vector3 outside;             ///< unit normal of the face that it was cut from
};

using CageLoops = std::vector<CageLoop>;

/// Edges as (low, high).
std::set<std::pair<Index, Index>> edges_of(const CageLoops& loops);

/// Every directed edge once and with its opposite, no corner twice in a loop, one fan of at least three faces
/// round every vertex, V - E + F = 2.
bool is_sphere(const CageLoops& loops);

/// Vertex `gone` becomes `kept`: loops that have no area any more disappear.
CageLoops collapsed(const CageLoops& loops, Index kept, Index gone);

}  // namespace hariko
