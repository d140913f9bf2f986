#pragma once

// Mirror: the designer models one half, the surface is made from both. Here is what a document says about it
// and which vertices lie in the plane; core/modeling/mirrored.hpp makes the whole.

#include <vector>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"
#include "core/geometry/mirror_plane.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

inline constexpr Code e_mirror_invalid{"E_MIRROR_INVALID"};

enum class Axis : std::uint8_t { x, y, z };

inline Eigen::Index index_of(Axis axis) {
  return static_cast<Eigen::Index>(axis);
}
/// Through zero, at right angles to an axis.
inline MirrorPlane mirror_plane(Axis axis) {
  return {static_cast<int>(axis), 0};
}

struct Mirror {
  /// The plane passes through the zero of the object's own space, at right angles to this axis.
  Axis axis = Axis::x;
  /// Border edges whose ends are at most so far from the plane join the two halves. A length in the object's
  /// space, 0 or more. (Not relative to the size: moving one far vertex must not open or close a seam.)
  double weld_distance = 0;
  friend bool operator==(const Mirror&, const Mirror&) = default;
};

/// E_MIRROR_INVALID: the weld distance is negative or not finite.
Result<Done> check_mirror(const Mirror& mirror);

/// One mark a vertex: whether it is one of the seam between the halves, hence an end of a border edge with
/// both ends near the plane. O(edges).
std::vector<char> mirror_seam(const Polyhedron& polyhedron, const Vector3& origin, const Mirror& mirror);

}  // namespace hariko
