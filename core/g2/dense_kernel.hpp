#pragma once

// Small dense matrix times three right-hand sides, or one: the inner loop of mode G2's solver, for the
// processor at hand. All variants add in the same order, so results do not depend on the processor.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/base/vector.hpp"

namespace hariko {

/// Columns one after the other, each padded with zeros to a multiple of eight rows.
struct PaddedMatrix {
  std::size_t rows = 0, stride = 0, columns = 0;
  std::vector<double> value;

  PaddedMatrix() = default;
  explicit PaddedMatrix(const Eigen::MatrixXd& matrix);
};

/// y[i] = sum_k m(i, k) x[k].
void multiply(const PaddedMatrix& matrix, const Vector3* x, Vector3* y);
void multiply(const PaddedMatrix& matrix, const double* x, double* y);

}  // namespace hariko
