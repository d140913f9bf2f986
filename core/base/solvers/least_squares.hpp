#pragma once

// Least squares of systems that have many solutions or none. The only place where Eigen's orthogonal
// factorisations of matrices of dynamic size are instantiated, which take ten seconds to compile.

#include "core/base/vector.hpp"

namespace hariko {

/// Least-squares solution with at most rank(matrix) nonzero entries: minimises |matrix x - right|.
Eigen::VectorXd solve_overdetermined(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
/// Minimum-norm least-squares solution: the shortest x that minimises |matrix x - right|.
Eigen::VectorXd solve_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// All least-squares solutions, the x that minimise |matrix x - right|: `shortest` plus any combination of
/// the columns of `free`, which are orthonormal.
struct LeastSquares {
  Eigen::VectorXd shortest;
  Eigen::MatrixXd free;
};
/// All least-squares solutions. Singular values below `rank_tolerance` of the largest count as zero.
LeastSquares all_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                               double rank_tolerance);

}  // namespace hariko
