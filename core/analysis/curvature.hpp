#pragma once

// Curvature of a surface at a point.

#include <optional>

#include "core/base/vector.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

/// Signs: positive where the surface bends away from its outward normal, so a sphere of radius r seen from
/// outside has k1 = k2 = 1/r. Units: 1/length, Gaussian curvature 1/length^2.
struct Curvature {
  double gauss = 0, mean = 0;
  double k1 = 0, k2 = 0;                                               ///< principal, k1 >= k2
  Vector3 direction1 = Vector3::Zero(), direction2 = Vector3::Zero();  ///< unit, tangential, orthogonal
  Vector3 normal = Vector3::Zero();                                    ///< unit outward
  /// k1 d1 d1^T + k2 d2 d2^T: does not depend on the parametrisation, so it compares across patches.
  Matrix3 tensor = Matrix3::Zero();
};

/// From position and both orders of derivatives. Nothing where ds and dt are parallel (as in `unit_normal`)
/// or a result is not finite. At umbilics the directions are any two orthogonal ones.
std::optional<Curvature> curvature(const PatchPoint& point);

}  // namespace hariko
