#pragma once

// MirrorPlane: a symmetry plane at right angles to a coordinate axis, and reflections in it.

#include "core/base/vector.hpp"

namespace hariko {

/// Symmetry plane across a coordinate axis of the space it lies in. Points in the plane are their own images,
/// to the last bit.
struct MirrorPlane {
  int axis = 1;         ///< 0, 1 or 2
  double position = 0;  ///< coordinate of the plane on the axis
  Vector3 normal() const { return Vector3::Unit(axis); }
  Vector3 point() const { return position * normal(); }
  /// Reflection of `p` in the plane.
  Vector3 image(Vector3 p) const {
    p[axis] = 2 * position - p[axis];
    return p;
  }
  /// Projection of `p` onto the plane.
  Vector3 foot(Vector3 p) const {
    p[axis] = position;
    return p;
  }
  friend bool operator==(const MirrorPlane&, const MirrorPlane&) = default;
};

}  // namespace hariko
