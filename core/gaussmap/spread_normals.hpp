#pragma once

// Normals along a loop from few of them, or from none.

#include <span>
#include <utility>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Unit chord from the point before to the one after, for each point of a closed loop: what normals are
/// perpendicular to (gaussmap.md 7). Where the two coincide, to the one after.
std::vector<Vector3> loop_tangents(std::span<const Vector3> points);

/// The vector area of a closed loop: half the sum of p_i x p_i+1, right-handed with the loop's direction.
Vector3 vector_area(std::span<const Vector3> points);

/// Unit normals at all points of a closed loop, perpendicular to it. `given`: normals by the places of their
/// points, places ascending; taken perpendicular to the loop. In between they turn about the loop smoothly,
/// by the arc length and the shorter way, relative to a frame that follows the loop without twist (double
/// reflection; Wang, Juettler, Zheng and Liu 2008) but for the turn that closes it. One normal alone goes
/// round with the loop. A given normal along the loop itself counts as not given; without any, the normals
/// are those of the loop's vector area. At least three points, neighbours apart. O(points).
std::vector<Vector3> spread_normals(std::span<const Vector3> points,
                                    std::span<const std::pair<std::size_t, Vector3>> given);

/// Unit normals perpendicular to a closed loop, turned from `axis` by `tilt` (radians, -pi/2 .. pi/2) to its
/// right: away from the surface where `axis` points out of it, so a dome has positive tilt.
std::vector<Vector3> tilted_normals(std::span<const Vector3> points, const Vector3& axis, double tilt);

}  // namespace hariko
