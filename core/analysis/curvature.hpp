#pragma once

// Curvature of a surface at a point.

#include <optional>

#include "core/base/vector.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

/// Curvature at a point. Signs: positive where the surface bends away from its outward normal, so a sphere of
/// radius r seen from outside has k1 = k2 = 1/r. Units: 1/length, Gaussian curvature 1/length^2.
struct Curvature {
  double gauss = 0, mean = 0;
  double k1 = 0, k2 = 0;             ///< principal curvatures, k1 >= k2
  Vector3 normal = Vector3::Zero();  ///< unit outward normal
  /// Curvature tensor k1 d1 d1^T + k2 d2 d2^T over the principal directions d1 and d2. It does not depend on
  /// the parametrisation, so it compares across patches.
  Matrix3 tensor = Matrix3::Zero();
};

/// Shape operator in an orthonormal frame of the tangent plane: the symmetric matrix [t11 t12; t12 t22] whose
/// eigenvalues are the principal curvatures, with the signs of `Curvature`. 1/length.
struct ShapeOperator {
  Vector3 normal = Vector3::Zero(), e1 = Vector3::Zero(), e2 = Vector3::Zero();
  double t11 = 0, t12 = 0, t22 = 0;

  double mean() const { return (t11 + t22) / 2; }
  double gauss() const { return t11 * t22 - t12 * t12; }
  /// Squared Frobenius norm of the tensor, k1^2 + k2^2.
  double squares() const { return t11 * t11 + 2 * (t12 * t12) + t22 * t22; }
  /// Curvature tensor, as `Curvature::tensor`.
  Matrix3 tensor() const;
};

/// Shape operator from first and second derivatives. Nothing where ds and dt are parallel (as in
/// `unit_normal`) or a result is not finite.
std::optional<ShapeOperator> shape_operator(const PatchPoint& point);

/// Curvature from first and second derivatives. Nothing where `shape_operator` gives nothing or a principal
/// curvature is not finite.
std::optional<Curvature> curvature(const PatchPoint& point);

}  // namespace hariko
