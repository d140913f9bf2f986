#pragma once

// RayMatrix: bending energy of a face's split edges as a function of its split point (kuriyama.md sections 3
// and 12.4).

#include "core/base/vector.hpp"

namespace hariko {

/// Matrix of the derivatives by O, Ys and Yc of sum w (|Y|^2 + O . Y + |O|^2 / 3), Y = p.y Ys + p.x Yc: the
/// energy of the split edges where the vertices and the split tangents are zero. Positive definite unless the
/// corners p lie on one line through 0.
class RayMatrix {
 public:
  /// Adds the split edge of a corner at p with a weight.
  void add(const Vector2& p, double weight) {
    const Vector3 q(1, p.y(), p.x());
    // Coefficients: 2/3 for O, 1 between O and Y, 2 for Y.
    matrix_ += weight * (2 * q * q.transpose());
    matrix_(0, 0) -= weight * 4 / 3;
    for (int i = 1; i < 3; ++i) {
      matrix_(0, i) -= weight * q[i];
      matrix_(i, 0) -= weight * q[i];
    }
  }

  /// Inverse by cofactors; exactly symmetric.
  Matrix3 inverse() const {
    const Matrix3& m = matrix_;
    Matrix3 c;
    c(0, 0) = m(1, 1) * m(2, 2) - m(1, 2) * m(1, 2);
    c(0, 1) = c(1, 0) = m(0, 2) * m(1, 2) - m(0, 1) * m(2, 2);
    c(0, 2) = c(2, 0) = m(0, 1) * m(1, 2) - m(0, 2) * m(1, 1);
    c(1, 1) = m(0, 0) * m(2, 2) - m(0, 2) * m(0, 2);
    c(1, 2) = c(2, 1) = m(0, 1) * m(0, 2) - m(0, 0) * m(1, 2);
    c(2, 2) = m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1);
    return c / (m(0, 0) * c(0, 0) + m(0, 1) * c(0, 1) + m(0, 2) * c(0, 2));
  }

 private:
  Matrix3 matrix_ = Matrix3::Zero();
};

}  // namespace hariko
