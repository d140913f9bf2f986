#pragma once

// MirrorPlane: a plane of symmetry at right angles to an axis, and images in it.

#include "core/base/vector.hpp"

namespace hariko {

/// Across an axis of the space that it is in. Images of points in the plane are these points to the last bit.
struct MirrorPlane {
  int axis = 1;         ///< 0, 1 or 2
  double position = 0;  ///< where the plane cuts the axis
  Vector3 normal() const { return Vector3::Unit(axis); }
  Vector3 point() const { return position * normal(); }
  Vector3 image(Vector3 p) const {
    p[axis] = 2 * position - p[axis];
    return p;
  }
  /// The point of the plane nearest to `p`.
  Vector3 foot(Vector3 p) const {
    p[axis] = position;
    return p;
  }
  friend bool operator==(const MirrorPlane&, const MirrorPlane&) = default;
};

}  // namespace hariko
