#include "core/g2/faces/dense_kernel.hpp"

#include <algorithm>

namespace hariko {

namespace {

typedef double Lane4 __attribute__((vector_size(32)));
#define HARIKO_INLINE inline __attribute__((always_inline))

HARIKO_INLINE void multiply_body(const PaddedMatrix& matrix, const Vector3* x, Vector3* y) {
  for (std::size_t row = 0; row < matrix.rows; row += 8) {
    Lane4 ax{}, ay{}, az{}, bx{}, by{}, bz{};
    const double* column = matrix.value.data() + row;
    for (std::size_t k = 0; k < matrix.columns; ++k, column += matrix.stride) {
      Lane4 a, b;
      __builtin_memcpy(&a, column, sizeof a);
      __builtin_memcpy(&b, column + 4, sizeof b);
      const double *v = x[k].data(), vx = v[0], vy = v[1], vz = v[2];
      ax += a * vx;
      ay += a * vy;
      az += a * vz;
      bx += b * vx;
      by += b * vy;
      bz += b * vz;
    }
    const std::size_t count = std::min<std::size_t>(8, matrix.rows - row);
    for (std::size_t i = 0; i < count; ++i)
      y[row + i] = i < 4 ? Vector3(ax[i], ay[i], az[i]) : Vector3(bx[i - 4], by[i - 4], bz[i - 4]);
  }
}

HARIKO_INLINE void multiply_one_body(const PaddedMatrix& matrix, const double* x, double* y) {
  for (std::size_t row = 0; row < matrix.rows; row += 8) {
    // Two accumulators each, so that additions do not wait for each other.
    Lane4 a0{}, a1{}, b0{}, b1{};
    const double* column = matrix.value.data() + row;
    const auto add = [&](Lane4 & a, Lane4 & b, double v) __attribute__((always_inline)) {
      Lane4 p, q;
      __builtin_memcpy(&p, column, sizeof p);
      __builtin_memcpy(&q, column + 4, sizeof q);
      a += p * v;
      b += q * v;
      column += matrix.stride;
    };
    std::size_t k = 0;
    for (; k + 2 <= matrix.columns; k += 2) {
      add(a0, b0, x[k]);
      add(a1, b1, x[k + 1]);
    }
    if (k < matrix.columns) add(a0, b0, x[k]);
    const Lane4 a = a0 + a1, b = b0 + b1;
    const std::size_t count = std::min<std::size_t>(8, matrix.rows - row);
    for (std::size_t i = 0; i < count; ++i) y[row + i] = i < 4 ? a[i] : b[i - 4];
  }
}

void multiply_base(const PaddedMatrix& matrix, const Vector3* x, Vector3* y) {
  multiply_body(matrix, x, y);
}
void multiply_one_base(const PaddedMatrix& matrix, const double* x, double* y) {
  multiply_one_body(matrix, x, y);
}
#if defined(__x86_64__)
__attribute__((target("avx2"))) void multiply_avx2(const PaddedMatrix& matrix, const Vector3* x, Vector3* y) {
  multiply_body(matrix, x, y);
}
__attribute__((target("avx2"))) void multiply_one_avx2(const PaddedMatrix& matrix, const double* x,
                                                       double* y) {
  multiply_one_body(matrix, x, y);
}
#endif

struct Multiply {
  void (*three)(const PaddedMatrix&, const Vector3*, Vector3*);
  void (*one)(const PaddedMatrix&, const double*, double*);
};

Multiply best() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return {multiply_avx2, multiply_one_avx2};
#endif
  return {multiply_base, multiply_one_base};
}

}  // namespace

PaddedMatrix::PaddedMatrix(const Eigen::MatrixXd& matrix)
    : rows(std::size_t(matrix.rows())), stride((rows + 7) / 8 * 8), columns(std::size_t(matrix.cols())) {
  value.assign(stride * columns, 0.0);
  for (std::size_t k = 0; k < columns; ++k)
    for (std::size_t i = 0; i < rows; ++i) value[k * stride + i] = matrix(Eigen::Index(i), Eigen::Index(k));
}

void multiply(const PaddedMatrix& matrix, const Vector3* x, Vector3* y) {
  static const Multiply kernel = best();
  kernel.three(matrix, x, y);
}

void multiply(const PaddedMatrix& matrix, const double* x, double* y) {
  static const Multiply kernel = best();
  kernel.one(matrix, x, y);
}

}  // namespace hariko
