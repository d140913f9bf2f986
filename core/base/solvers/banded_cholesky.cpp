#include "core/base/solvers/banded_cholesky.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

double dot(const double* a, const double* b, std::size_t count) {
  using Row = Eigen::Map<const Eigen::VectorXd>;
  return Row(a, Eigen::Index(count)).dot(Row(b, Eigen::Index(count)));
}

}  // namespace

BandedCholesky::BandedCholesky(std::size_t size, std::size_t bandwidth)
    : size_(size), bandwidth_(std::min(bandwidth, size > 0 ? size - 1 : 0)) {
  rows_.assign(size_ * (bandwidth_ + 1), 0);
}

bool BandedCholesky::factor() {
  for (std::size_t i = 0; i < size_; ++i) {
    double* own = rows_.data() + i * (bandwidth_ + 1) + bandwidth_ - i;
    for (std::size_t k = first(i); k < i; ++k) {
      const std::size_t from = std::max(first(i), first(k));
      const double* other = row(k);
      own[k] = (own[k] - dot(own + from, other + from, k - from)) / other[k];
    }
    const double left = own[i] - dot(own + first(i), own + first(i), i - first(i));
    if (!(left > 1e-14 * own[i])) return false;
    own[i] = std::sqrt(left);
  }
  return true;
}

void BandedCholesky::solve(std::span<double> right) const {
  HARIKO_ASSERT(right.size() == size_, "one number a row");
  for (std::size_t i = 0; i < size_; ++i) {
    const std::size_t from = first(i);
    right[i] = (right[i] - dot(row(i) + from, right.data() + from, i - from)) / row(i)[i];
  }
  for (std::size_t i = size_; i-- > 0;) {
    right[i] /= row(i)[i];
    for (std::size_t k = first(i); k < i; ++k) right[k] -= row(i)[k] * right[i];
  }
}

}  // namespace hariko
