#pragma once

// Dense linear algebra. The only door to Eigen's factorisations and to its products of matrices whose size is
// known at run time: each use of those templates elsewhere costs seconds of compile time.

#include <optional>

#include <Eigen/Core>

#include "core/base/vector.hpp"

namespace hariko {

/// a b
Eigen::MatrixXd matrix_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
Eigen::VectorXd matrix_product(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// a^T b
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
Eigen::VectorXd transposed_product(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// a^T a, the lower triangle; zero above the diagonal.
Eigen::MatrixXd lower_gram_matrix(const Eigen::MatrixXd& a);

/// Entry (i, k) times scale[i] scale[k]; the matrix is square.
Eigen::MatrixXd scaled_both_sides(const Eigen::VectorXd& scale, const Eigen::MatrixXd& matrix);

/// The matrix must not be singular.
Eigen::MatrixXd inverse_matrix(const Eigen::MatrixXd& matrix);
/// By triangular factors with row pivots. The matrix must not be singular.
Eigen::VectorXd solve_general(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
/// By L D L^T with pivots; `matrix` is symmetric and, but for rounding, semidefinite.
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
/// By L L^T, all columns of `right`; empty where `matrix` is not positive definite.
std::optional<Eigen::MatrixXd> solve_definite(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// As `solve_definite`, for matrices that are positive definite but for rounding and have a positive
/// diagonal: eigenvalues that are, relative to the diagonal, below what rounding leaves of them count as
/// that.
Eigen::MatrixXd solve_nearly_definite(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// Eigenvalues of a symmetric matrix, ascending; its lower triangle is read.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

}  // namespace hariko
