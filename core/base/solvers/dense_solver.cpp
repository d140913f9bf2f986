#include "core/base/solvers/dense_solver.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <limits>

#include "core/base/assert.hpp"

namespace hariko {

Eigen::MatrixXd matrix_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a * b;
}

Eigen::VectorXd matrix_product(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a * b;
}

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.transpose() * b;
}

Eigen::VectorXd transposed_product(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.transpose() * b;
}

Eigen::MatrixXd lower_gram_matrix(const Eigen::MatrixXd& a) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(a.cols(), a.cols());
  out.selfadjointView<Eigen::Lower>().rankUpdate(a.transpose());
  return out;
}

Eigen::MatrixXd scaled_both_sides(const Eigen::VectorXd& scale, const Eigen::MatrixXd& matrix) {
  Eigen::MatrixXd out(matrix.rows(), matrix.cols());
  for (Eigen::Index k = 0; k < matrix.cols(); ++k)
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) out(i, k) = scale[i] * matrix(i, k) * scale[k];
  return out;
}

Eigen::MatrixXd inverse_matrix(const Eigen::MatrixXd& matrix) {
  return matrix.inverse();
}

Eigen::VectorXd solve_general(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.partialPivLu().solve(right);
}

Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.ldlt().solve(right);
}

std::optional<Eigen::MatrixXd> solve_definite(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) return std::nullopt;
  return factor.solve(right);
}

Eigen::MatrixXd solve_nearly_definite(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  if (auto solved = solve_definite(matrix, right)) return std::move(*solved);
  HARIKO_ASSERT(matrix.diagonal().minCoeff() > 0, "the diagonal of a definite matrix is positive");
  const Eigen::VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled_both_sides(scale, matrix));
  const double least =
      double(matrix.rows()) * std::numeric_limits<double>::epsilon() * solver.eigenvalues().maxCoeff();
  const Eigen::VectorXd raised = solver.eigenvalues().cwiseMax(least).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd root = scale.asDiagonal() * solver.eigenvectors() * raised.asDiagonal();
  return matrix_product(root, transposed_product(root, right));
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return {};
  Eigen::MatrixXd scaled = matrix.triangularView<Eigen::Lower>();
  double scale = scaled.cwiseAbs().maxCoeff();
  if (scale == 0) scale = 1;
  scaled /= scale;
  // Tridiagonalises step by step: the solver's own constructor would compile eigenvectors as well.
  Eigen::VectorXd diagonal = scaled.diagonal(), beside;
  if (matrix.rows() > 1) {
    const Eigen::Tridiagonalization<Eigen::MatrixXd> form(scaled);
    diagonal = form.diagonal();
    beside = form.subDiagonal();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  return solver.eigenvalues() * scale;
}

}  // namespace hariko
