#pragma once

// Sparse linear systems. The only door to Eigen's sparse factorisations and sparse products, whose templates
// take seconds to compile in each file that uses them.

#include <memory>
#include <vector>

#include <Eigen/SparseCore>

namespace hariko {

using SparseMatrix = Eigen::SparseMatrix<double>;
using SparseEntries = std::vector<Eigen::Triplet<double>>;

/// Entries at the same place are added up.
SparseMatrix sparse_matrix(Eigen::Index rows, Eigen::Index columns, const SparseEntries& entries);
/// a b
SparseMatrix sparse_product(const SparseMatrix& a, const SparseMatrix& b);
/// a^T b
SparseMatrix transposed_product(const SparseMatrix& a, const SparseMatrix& b);
/// `matrix` with row i times scale[i].
SparseMatrix scaled_rows(const Eigen::VectorXd& scale, const SparseMatrix& matrix);

/// L D L^T of a symmetric matrix, with an ordering of minimum degree; its lower triangle is read.
class SparseCholesky {
 public:
  explicit SparseCholesky(const SparseMatrix& matrix);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// False where a pivot is zero: nothing can be solved.
  bool succeeded() const;
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

/// L U of a square matrix, with row pivots.
class SparseLu {
 public:
  explicit SparseLu(const SparseMatrix& matrix);
  ~SparseLu();
  SparseLu(const SparseLu&) = delete;
  SparseLu& operator=(const SparseLu&) = delete;

  /// False where the matrix is singular: nothing can be solved.
  bool succeeded() const;
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace hariko
