#pragma once

// Systems that have many solutions or none. The only door to Eigen's orthogonal factorisations of matrices
// whose size is known at run time, which take ten seconds to compile.

#include "core/base/vector.hpp"

namespace hariko {

/// An x that makes matrix x - right shortest; as many of its entries as the rank allows are not zero.
Eigen::VectorXd solve_overdetermined(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
/// The shortest x of those that make matrix x - right shortest.
Eigen::VectorXd solve_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Everything that makes matrix x - right shortest: `shortest` plus any combination of the columns of `free`,
/// which are orthonormal.
struct LeastSquares {
  Eigen::VectorXd shortest;
  Eigen::MatrixXd free;
};
/// Singular values below `rank_tolerance` of the largest count as zero.
LeastSquares all_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                               double rank_tolerance);

}  // namespace hariko
