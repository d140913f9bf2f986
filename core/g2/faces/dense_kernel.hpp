#pragma once

// Product of a small dense matrix with three right-hand sides, or one: the inner loop of mode G2's solver, by
// kind of processor. All variants add in the same order, so results do not depend on the processor.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/base/vector.hpp"

namespace hariko {

/// Column-major matrix, each column padded with zeros to a multiple of eight rows.
struct PaddedMatrix {
  std::size_t rows = 0, stride = 0, columns = 0;
  std::vector<double> value;

  PaddedMatrix() = default;
  explicit PaddedMatrix(const Eigen::MatrixXd& matrix);
};

/// Matrix product y[i] = sum_k m(i, k) x[k].
void multiply(const PaddedMatrix& matrix, const Vector3* x, Vector3* y);
void multiply(const PaddedMatrix& matrix, const double* x, double* y);

}  // namespace hariko
