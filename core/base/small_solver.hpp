#pragma once

// Linear systems and axes of two to four unknowns. Eigen's factorisations of such matrices take seconds of
// compile time in each file that uses them; these give the same bits.

#include "core/base/vector.hpp"

namespace hariko {

/// By L D L^T with pivots: `matrix` is symmetric and, but for rounding, semidefinite. Unknowns of zero pivots
/// are zero.
Vector2 solve_symmetric(const Eigen::Matrix2d& matrix, const Vector2& right);
Vector3 solve_symmetric(const Matrix3& matrix, const Vector3& right);
Eigen::Vector4d solve_symmetric(const Eigen::Matrix4d& matrix, const Eigen::Vector4d& right);
/// By L U with full pivots: a solution where there is none but for rounding; one of many where `matrix` is
/// singular.
Vector2 solve_general(const Eigen::Matrix2d& matrix, const Vector2& right);

/// Eigenvalues of a symmetric matrix, ascending, and unit eigenvectors, the columns of `vectors`.
struct SymmetricAxes {
  Vector3 values;
  Matrix3 vectors;
};
SymmetricAxes symmetric_axes(const Matrix3& matrix);

/// matrix = u diagonal(values) v^T, values descending. Of a matrix that is not finite: no values, no turns.
struct SingularAxes {
  Vector3 values = Vector3::Zero();
  Matrix3 u = Matrix3::Identity(), v = Matrix3::Identity();
};
SingularAxes singular_axes(const Matrix3& matrix);

}  // namespace hariko
