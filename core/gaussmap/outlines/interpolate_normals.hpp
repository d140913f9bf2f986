#pragma once

// Interpolation of normals along a loop from a few of them, or from none.

#include <span>
#include <utility>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Unit chord from the previous point to the next one, for each point of a closed loop; normals are
/// perpendicular to it (gaussmap.md 7). Where the two coincide, the direction to the next point.
std::vector<Vector3> loop_tangents(std::span<const Vector3> points);

/// Vector area of a closed loop: half the sum of p_i x p_i+1, right-handed with the loop's direction.
Vector3 vector_area(std::span<const Vector3> points);

/// Unit normals at all points of a closed loop, perpendicular to it. `given`: normals by the places of their
/// points, places ascending; they are projected perpendicular to the loop. In between normals rotate about
/// the loop smoothly, by the arc length and the shorter way, relative to a rotation-minimising frame (double
/// reflection; Wang, Juettler, Zheng and Liu 2008) whose closing angle is distributed. A single normal is
/// carried round by that frame. A given normal along the loop itself counts as not given; without any, the
/// normals are those of the loop's vector area. At least three points, neighbours distinct. O(points).
std::vector<Vector3> spread_normals(std::span<const Vector3> points,
                                    std::span<const std::pair<std::size_t, Vector3>> given);

/// Unit normals perpendicular to a closed loop, rotated from `axis` by `tilt` (radians, -pi/2 .. pi/2) to its
/// right: away from the surface where `axis` points out of it, so that a dome has positive tilt.
std::vector<Vector3> tilted_normals(std::span<const Vector3> points, const Vector3& axis, double tilt);

}  // namespace hariko
