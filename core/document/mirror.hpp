#pragma once

// Mirror: the designer models one half, the surface is made from both. This is the document's data and the
// test for vertices in the plane; core/modeling/surfacing/mirrored.hpp makes the whole.

#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/geometry/mirror_plane.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

inline constexpr Code e_mirror_invalid{"E_MIRROR_INVALID"};

enum class Axis : std::uint8_t { x, y, z };

/// Index of the axis' coordinate, 0 .. 2.
inline Eigen::Index index_of(Axis axis) {
  return static_cast<Eigen::Index>(axis);
}
/// Plane through the origin, perpendicular to an axis.
inline MirrorPlane mirror_plane(Axis axis) {
  return {static_cast<int>(axis), 0};
}

/// Live mirror of a polyhedron object.
struct Mirror {
  /// Normal of the plane, which passes through the origin of the object's own space.
  Axis axis = Axis::x;
  /// Largest distance from the plane of the ends of border edges that join the two halves. A length in the
  /// object's space, 0 or more. (Not relative to the size: moving one distant vertex must not open or close a
  /// seam.)
  double weld_distance = 0;
  friend bool operator==(const Mirror&, const Mirror&) = default;
};

/// Checks a mirror. E_MIRROR_INVALID: the weld distance is negative or not finite.
Result<Done> check_mirror(const Mirror& mirror);

/// Seam between the halves: one flag per vertex, set at the ends of border edges with both ends near the
/// plane. O(edges).
std::vector<char> mirror_seam(const Polyhedron& polyhedron, const Vector3& origin, const Mirror& mirror);

}  // namespace hariko
