#include "core/base/solvers/small_solver.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hariko {

namespace {

/// Factorises L D L^T in place, L below the diagonal and D on it, with rows and columns permuted: k exchanged
/// with pivot[k], one after the other. False for the zero matrix.
template <int n>
bool factorise(Eigen::Matrix<double, n, n>& m, std::array<int, n>& pivot) {
  for (int k = 0; k < n; ++k) {
    int best = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(m(i, i)) > std::abs(m(best, best))) best = i;
    pivot[std::size_t(k)] = best;
    if (best != k) {
      for (int i = 0; i < k; ++i) std::swap(m(k, i), m(best, i));
      for (int i = best + 1; i < n; ++i) std::swap(m(i, k), m(i, best));
      for (int i = k + 1; i < best; ++i) std::swap(m(i, k), m(best, i));
      std::swap(m(k, k), m(best, best));
    }
    for (int i = k; i < n && k > 0; ++i) {
      double sum = m(i, 0) * (m(0, 0) * m(k, 0));
      for (int j = 1; j < k; ++j) sum += m(i, j) * (m(j, j) * m(k, j));
      m(i, k) -= sum;
    }
    if (std::abs(m(k, k)) > 0)
      for (int i = k + 1; i < n; ++i) m(i, k) /= m(k, k);
    else if (k == 0)
      return false;
  }
  return true;
}

template <int n>
Eigen::Matrix<double, n, 1> solve_ldlt(Eigen::Matrix<double, n, n> m, Eigen::Matrix<double, n, 1> x) {
  std::array<int, n> pivot{};
  if (!factorise<n>(m, pivot)) return Eigen::Matrix<double, n, 1>::Zero();
  for (int k = 0; k < n; ++k) std::swap(x[k], x[pivot[std::size_t(k)]]);
  for (int i = 1; i < n; ++i) {
    double sum = m(i, i - 1) * x[i - 1];
    for (int j = i - 2; j >= 0; --j) sum = m(i, j) * x[j] + sum;
    x[i] -= sum;
  }
  for (int i = 0; i < n; ++i)
    x[i] = std::abs(m(i, i)) > std::numeric_limits<double>::min() ? x[i] / m(i, i) : 0;
  for (int i = n - 2; i >= 0; --i) {
    double sum = m(i + 1, i) * x[i + 1];
    for (int j = i + 2; j < n; ++j) sum += m(j, i) * x[j];
    x[i] -= sum;
  }
  for (int k = n - 1; k >= 0; --k) std::swap(x[k], x[pivot[std::size_t(k)]]);
  return x;
}

}  // namespace

Vector2 solve_symmetric(const Eigen::Matrix2d& matrix, const Vector2& right) {
  return solve_ldlt<2>(matrix, right);
}

Vector3 solve_symmetric(const Matrix3& matrix, const Vector3& right) {
  return solve_ldlt<3>(matrix, right);
}

Eigen::Vector4d solve_symmetric(const Eigen::Matrix4d& matrix, const Eigen::Vector4d& right) {
  return solve_ldlt<4>(matrix, right);
}

Vector2 solve_general(const Eigen::Matrix2d& matrix, const Vector2& right) {
  int row = 0, column = 0;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i)
      if (std::abs(matrix(i, j)) > std::abs(matrix(row, column))) row = i, column = j;
  const double largest = matrix(row, column);
  if (largest == 0) return Vector2::Zero();
  const double beside = matrix(row, 1 - column), below = matrix(1 - row, column) / largest;
  const double last = matrix(1 - row, 1 - column) - below * beside;
  Vector2 x = Vector2::Zero();
  const double first = right[row], second = right[1 - row] - below * first;
  const double most = std::max(std::abs(largest), std::abs(last));
  if (std::abs(last) > most * (2 * std::numeric_limits<double>::epsilon())) {
    x[1 - column] = second / last;
    x[column] = (first - beside * x[1 - column]) / largest;
  } else {
    x[column] = first / largest;
  }
  return x;
}

SymmetricAxes symmetric_axes(const Matrix3& matrix) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

SingularAxes singular_axes(const Matrix3& matrix) {
  SingularAxes out;
  const Eigen::JacobiSVD<Matrix3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (svd.info() != Eigen::Success) return out;
  out.values = svd.singularValues();
  out.u = svd.matrixU();
  out.v = svd.matrixV();
  return out;
}

}  // namespace hariko
