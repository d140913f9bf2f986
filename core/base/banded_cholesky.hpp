#pragma once

// Symmetric positive definite systems whose entries lie near the diagonal.

#include <cstddef>
#include <span>
#include <vector>

namespace hariko {

/// L L^T of a matrix of which entry (i, k) is zero where |i - k| > bandwidth. O(size bandwidth^2), and O(size
/// bandwidth) for a solution.
class BandedCholesky {
 public:
  BandedCholesky(std::size_t size, std::size_t bandwidth);

  std::size_t size() const { return size_; }
  /// Entry of the lower triangle before `factor`; column <= row <= column + bandwidth.
  double& entry(std::size_t row, std::size_t column) {
    return rows_[row * (bandwidth_ + 1) + column + bandwidth_ - row];
  }
  /// False where the matrix is not positive definite: nothing can be solved.
  bool factor();
  /// Replaces `right` by the solution.
  void solve(std::span<double> right) const;

 private:
  const double* row(std::size_t i) const { return rows_.data() + i * (bandwidth_ + 1) + bandwidth_ - i; }
  std::size_t first(std::size_t i) const { return i > bandwidth_ ? i - bandwidth_ : 0; }

  std::size_t size_, bandwidth_;
  std::vector<double> rows_;  ///< of the lower triangle, each from `bandwidth` before the diagonal on
};

}  // namespace hariko
