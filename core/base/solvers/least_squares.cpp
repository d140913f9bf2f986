#include "core/base/solvers/least_squares.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace hariko {

Eigen::VectorXd solve_overdetermined(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

Eigen::VectorXd solve_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.completeOrthogonalDecomposition().solve(right);
}

LeastSquares all_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                               double rank_tolerance) {
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeFullV);
  svd.setThreshold(rank_tolerance);
  return {svd.solve(right), svd.matrixV().rightCols(matrix.cols() - svd.rank())};
}

}  // namespace hariko
