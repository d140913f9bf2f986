#pragma once

// Linear systems, eigenvalues and singular values of two to four dimensions. Eigen's factorisations of such
// matrices take seconds of compile time in each file that uses them; these give the same bits.

#include "core/base/vector.hpp"

namespace hariko {

/// Solution of a symmetric system, by L D L^T with pivoting: `matrix` is semidefinite up to rounding.
/// Unknowns of zero pivots are zero.
Vector2 solve_symmetric(const Eigen::Matrix2d& matrix, const Vector2& right);
Vector3 solve_symmetric(const Matrix3& matrix, const Vector3& right);
Eigen::Vector4d solve_symmetric(const Eigen::Matrix4d& matrix, const Eigen::Vector4d& right);
/// Solution of a general system, by LU with full pivoting. Where `matrix` is singular: one of many solutions,
/// or of those up to rounding.
Vector2 solve_general(const Eigen::Matrix2d& matrix, const Vector2& right);

/// Eigenvalues of a symmetric matrix, ascending, and unit eigenvectors, the columns of `vectors`.
struct SymmetricAxes {
  Vector3 values;
  Matrix3 vectors;
};
/// Eigenvalue decomposition of a symmetric matrix.
SymmetricAxes symmetric_axes(const Matrix3& matrix);

/// Singular value decomposition: matrix = u diagonal(values) v^T, values descending. Zero values and
/// identities for a matrix that is not finite.
struct SingularAxes {
  Vector3 values = Vector3::Zero();
  Matrix3 u = Matrix3::Identity(), v = Matrix3::Identity();
};
/// Singular value decomposition of a matrix.
SingularAxes singular_axes(const Matrix3& matrix);

}  // namespace hariko
