#pragma once

// Similarity: placement of an object in the document by rotation, uniform scale and translation. Further
// places of live copies may be mirror images.

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/vector.hpp"

namespace hariko {

/// Maps x to translation + scale * (rotation x). Invariants (checked by `set_transform` and the file reader):
/// everything finite, rotation a unit quaternion to 1e-9, min_scale <= scale <= max_scale. A place of live
/// copies that is a mirror image has a negative scale: an inversion through zero and a half turn are a
/// reflection.
struct Similarity {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  double scale = 1;
  Vector3 translation = Vector3::Zero();  ///< in the document's unit

  static constexpr double min_scale = 1e-9, max_scale = 1e9;

  Vector3 apply(const Vector3& point) const { return translation + scale * (rotation * point); }
  /// Maps a direction: rotated and scaled, not translated.
  Vector3 apply_to_vector(const Vector3& vector) const { return scale * (rotation * vector); }
  /// Maps a unit normal that points outward to one that points outward.
  Vector3 apply_to_normal(const Vector3& normal) const {
    const Vector3 turned = rotation * normal;
    return mirrors() ? Vector3(-turned) : turned;
  }
  /// Whether it makes mirror images: the corners of a face are then in the opposite order.
  bool mirrors() const { return scale < 0; }
  /// Ratio of lengths, which is positive.
  double length_scale() const { return std::abs(scale); }
  Similarity inverse() const {
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, 1 / scale, -(back * translation) / scale};
  }

  friend bool operator==(const Similarity& a, const Similarity& b) {
    return a.rotation.coeffs() == b.rotation.coeffs() && a.scale == b.scale && a.translation == b.translation;
  }
};

/// Reflection in the plane through a point at right angles to a unit normal.
inline Similarity reflection_in(const Vector3& point, const Vector3& normal) {
  return {Eigen::Quaterniond(0, normal.x(), normal.y(), normal.z()), -1, 2 * normal.dot(point) * normal};
}

/// Place of a reflected source: it takes what is reflected across an own axis (0, 1 or 2), in the plane
/// through zero, to where `mirrored`, which mirrors, takes what is not. It does not mirror.
inline Similarity place_of_reflected(const Similarity& mirrored, int axis) {
  const Vector3 own = Vector3::Unit(axis);
  const Eigen::Quaterniond half_turn(0, own.x(), own.y(), own.z());
  return {(mirrored.rotation * half_turn).normalized(), -mirrored.scale, mirrored.translation};
}

/// Similarity that maps x to outer(inner(x)).
inline Similarity composed(const Similarity& outer, const Similarity& inner) {
  return {(outer.rotation * inner.rotation).normalized(), outer.scale * inner.scale,
          outer.apply(inner.translation)};
}

}  // namespace hariko
