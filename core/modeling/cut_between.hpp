#pragma once

// A straight cut over several faces: where it crosses the edges between two points.

#include "core/base/result.hpp"
#include "core/modeling/cut.hpp"

namespace hariko {

/// The points on edges and vertices that a cut from one point to another passes, both excluded: it runs in
/// the plane through `from` that is normal to `normal` (relative to the polyhedron; any length but zero),
/// which should hold `to`. Of several ways round the polyhedron the shortest is taken. Empty where the points
/// lie on a common face. Crossings that nearly meet a vertex go through it. `cut_path` through all the points
/// makes the cut, or says where it would leave a concave face. O(n log n) in the faces passed. Errors:
/// E_UNKNOWN_ELEMENT, E_BAD_AMOUNT (a share outside 0 .. 1, a normal that is none), E_WRONG_SELECTION (no way
/// in the plane leads from one to the other).
Result<std::vector<CutPoint>> cut_between(const Polyhedron& polyhedron, const CutPoint& from,
                                          const CutPoint& to, const Vector3& normal);

/// Where a point of a path lies; the elements must exist.
Vector3 position_of(const Polyhedron& polyhedron, const CutPoint& point);

}  // namespace hariko
