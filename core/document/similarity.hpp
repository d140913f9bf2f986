#pragma once

// Similarity: placement of an object in the document by rotation, uniform scale and translation.

#include <Eigen/Geometry>

#include "core/base/vector.hpp"

namespace hariko {

/// Maps x to translation + scale * (rotation x). Invariants (checked by `set_transform` and the file reader):
/// everything finite, rotation a unit quaternion to 1e-9, min_scale <= scale <= max_scale.
struct Similarity {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  double scale = 1;
  Vector3 translation = Vector3::Zero();  ///< in the document's unit

  static constexpr double min_scale = 1e-9, max_scale = 1e9;

  Vector3 apply(const Vector3& point) const { return translation + scale * (rotation * point); }
  /// Maps a direction: rotated and scaled, not translated.
  Vector3 apply_to_vector(const Vector3& vector) const { return scale * (rotation * vector); }
  Similarity inverse() const {
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, 1 / scale, -(back * translation) / scale};
  }

  friend bool operator==(const Similarity& a, const Similarity& b) {
    return a.rotation.coeffs() == b.rotation.coeffs() && a.scale == b.scale && a.translation == b.translation;
  }
};

/// Similarity that maps x to outer(inner(x)).
inline Similarity composed(const Similarity& outer, const Similarity& inner) {
  return {(outer.rotation * inner.rotation).normalized(), outer.scale * inner.scale,
          outer.apply(inner.translation)};
}

}  // namespace hariko
