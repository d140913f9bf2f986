#pragma once

// Cholesky factorisation of symmetric positive definite band matrices.

#include <cstddef>
#include <span>
#include <vector>

namespace hariko {

/// Cholesky factorisation L L^T of a band matrix: entry (i, k) is zero where |i - k| > bandwidth. Factorising
/// takes O(size bandwidth^2), a solution O(size bandwidth).
class BandedCholesky {
 public:
  BandedCholesky(std::size_t size, std::size_t bandwidth);

  std::size_t size() const { return size_; }
  /// Entry of the lower triangle, to be set before `factor`; column <= row <= column + bandwidth.
  double& entry(std::size_t row, std::size_t column) {
    return rows_[row * (bandwidth_ + 1) + column + bandwidth_ - row];
  }
  /// Factorises in place; false where the matrix is not positive definite, and then nothing can be solved.
  bool factor();
  /// Replaces `right` by the solution.
  void solve(std::span<double> right) const;

 private:
  const double* row(std::size_t i) const { return rows_.data() + i * (bandwidth_ + 1) + bandwidth_ - i; }
  std::size_t first(std::size_t i) const { return i > bandwidth_ ? i - bandwidth_ : 0; }

  std::size_t size_, bandwidth_;
  /// Lower triangle, row by row; each row begins `bandwidth` columns before the diagonal.
  std::vector<double> rows_;
};

}  // namespace hariko
