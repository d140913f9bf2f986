#include "core/document/angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hariko {

namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

Vector3 angles_of(const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d m = rotation.toRotationMatrix();
  const double y = std::asin(std::clamp(-m(2, 0), -1.0, 1.0));
  constexpr double nearly_one = 1 - 1e-12;
  Vector3 angles(0, y, 0);
  if (std::abs(m(2, 0)) < nearly_one) {
    angles.x() = std::atan2(m(2, 1), m(2, 2));
    angles.z() = std::atan2(m(1, 0), m(0, 0));
  } else {
    angles.z() = std::atan2(-m(0, 1), m(1, 1));
  }
  return angles / degree;
}

Eigen::Quaterniond rotation_of(const Vector3& degrees) {
  const Vector3 angles = degrees * degree;
  return Eigen::AngleAxisd(angles.z(), Vector3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vector3::UnitY()) *
         Eigen::AngleAxisd(angles.x(), Vector3::UnitX());
}

}  // namespace hariko
