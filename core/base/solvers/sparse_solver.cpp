#include "core/base/solvers/sparse_solver.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

namespace hariko {

SparseMatrix sparse_matrix(Eigen::Index rows, Eigen::Index columns, const SparseEntries& entries) {
  SparseMatrix out(rows, columns);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

SparseMatrix sparse_product(const SparseMatrix& a, const SparseMatrix& b) {
  return a * b;
}

SparseMatrix transposed_product(const SparseMatrix& a, const SparseMatrix& b) {
  return a.transpose() * b;
}

SparseMatrix scaled_rows(const Eigen::VectorXd& scale, const SparseMatrix& matrix) {
  return scale.asDiagonal() * matrix;
}

struct SparseCholesky::Factor {
  Eigen::SimplicialLDLT<SparseMatrix> solver;
};

SparseCholesky::SparseCholesky(const SparseMatrix& matrix) : factor_(std::make_unique<Factor>()) {
  factor_->solver.compute(matrix);
}
SparseCholesky::~SparseCholesky() = default;

bool SparseCholesky::succeeded() const {
  return factor_->solver.info() == Eigen::Success;
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& right) const {
  return factor_->solver.solve(right);
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right) const {
  return factor_->solver.solve(right);
}

struct SparseLu::Factor {
  Eigen::SparseLU<SparseMatrix> solver;
};

SparseLu::SparseLu(const SparseMatrix& matrix) : factor_(std::make_unique<Factor>()) {
  factor_->solver.compute(matrix);
}
SparseLu::~SparseLu() = default;

bool SparseLu::succeeded() const {
  return factor_->solver.info() == Eigen::Success;
}

Eigen::VectorXd SparseLu::solve(const Eigen::VectorXd& right) const {
  return factor_->solver.solve(right);
}

}  // namespace hariko
