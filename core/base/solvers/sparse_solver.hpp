#pragma once

// Sparse linear systems. The only place where Eigen's sparse factorisations and sparse products are
// instantiated, whose templates take seconds to compile in each file that uses them.

#include <memory>
#include <vector>

#include <Eigen/SparseCore>

namespace hariko {

using SparseMatrix = Eigen::SparseMatrix<double>;
using SparseEntries = std::vector<Eigen::Triplet<double>>;

/// Sparse matrix of a list of entries; entries at the same place are added up.
SparseMatrix sparse_matrix(Eigen::Index rows, Eigen::Index columns, const SparseEntries& entries);
/// Product a b.
SparseMatrix sparse_product(const SparseMatrix& a, const SparseMatrix& b);
/// Product a^T b.
SparseMatrix transposed_product(const SparseMatrix& a, const SparseMatrix& b);
/// Copy of `matrix` with row i multiplied by scale[i].
SparseMatrix scaled_rows(const Eigen::VectorXd& scale, const SparseMatrix& matrix);

/// Cholesky factorisation L D L^T of a symmetric matrix, with a minimum degree ordering; its lower triangle
/// is read.
class SparseCholesky {
 public:
  explicit SparseCholesky(const SparseMatrix& matrix);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// True where the factorisation succeeded; false where a pivot is zero, and then nothing can be solved.
  bool succeeded() const;
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  /// Solutions for all columns of `right`.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

/// LU factorisation of a square matrix, with row pivoting.
class SparseLu {
 public:
  explicit SparseLu(const SparseMatrix& matrix);
  ~SparseLu();
  SparseLu(const SparseLu&) = delete;
  SparseLu& operator=(const SparseLu&) = delete;

  /// True where the factorisation succeeded; false where the matrix is singular, and then nothing can be
  /// solved.
  bool succeeded() const;
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace hariko
