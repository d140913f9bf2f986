#pragma once

// Dense linear algebra. The only place where Eigen's dense factorisations and products of matrices of dynamic
// size are instantiated: each use of those templates elsewhere costs seconds of compile time.

#include <optional>

#include <Eigen/Core>

#include "core/base/vector.hpp"

namespace hariko {

/// Product a b.
Eigen::MatrixXd matrix_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
Eigen::VectorXd matrix_product(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// Product a^T b.
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
Eigen::VectorXd transposed_product(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// Gram matrix a^T a: its lower triangle; zero above the diagonal.
Eigen::MatrixXd lower_gram_matrix(const Eigen::MatrixXd& a);

/// Diagonal scaling D M D: entry (i, k) times scale[i] scale[k]; the matrix is square.
Eigen::MatrixXd scaled_both_sides(const Eigen::VectorXd& scale, const Eigen::MatrixXd& matrix);

/// Inverse of a square matrix, which must not be singular.
Eigen::MatrixXd inverse_matrix(const Eigen::MatrixXd& matrix);
/// Solution of a general square system, by LU with row pivoting. The matrix must not be singular.
Eigen::VectorXd solve_general(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
/// Solution of a symmetric system, by L D L^T with pivoting; `matrix` is semidefinite up to rounding.
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
/// Solution of a positive definite system for all columns of `right`, by Cholesky; empty where `matrix` is
/// not positive definite.
std::optional<Eigen::MatrixXd> solve_definite(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// Solution of a system whose matrix is positive semidefinite up to rounding and has a positive diagonal, for
/// all columns of `right`. Eigenvalues that rounding cannot tell from zero, relative to the diagonal, are
/// raised to that threshold.
Eigen::MatrixXd solve_nearly_definite(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// Eigenvalues of a symmetric matrix, ascending; its lower triangle is read.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

}  // namespace hariko
