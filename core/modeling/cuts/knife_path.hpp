#pragma once

// Straight cut over several faces: the points where it crosses the edges between its ends.

#include "core/base/result.hpp"
#include "core/modeling/cuts/cut.hpp"

namespace hariko {

/// Returns the points on edges and vertices that a straight cut from one point to another passes, both ends
/// excluded. The cut lies in the plane through `from` that is normal to `normal` (relative to the polyhedron;
/// any length but zero), which should contain `to`. Of several ways round the polyhedron the shortest is
/// taken. Empty where the points lie on a common face. Crossings very near a vertex are moved to the vertex.
/// `cut_path` through all the points makes the cut, or reports where it would leave a concave face. O(n log
/// n) in the faces passed. Errors: E_UNKNOWN_ELEMENT, E_BAD_AMOUNT (a share outside 0 .. 1, a zero or
/// non-finite normal), E_WRONG_SELECTION (no way in the plane leads from one point to the other).
Result<std::vector<CutPoint>> knife_path(const Polyhedron& polyhedron, const CutPoint& from,
                                         const CutPoint& to, const Vector3& normal);

/// Position of a point of a path; its element must exist.
Vector3 position_of(const Polyhedron& polyhedron, const CutPoint& point);

}  // namespace hariko
