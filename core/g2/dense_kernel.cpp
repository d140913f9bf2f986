#include "core/g2/dense_kernel.hpp"

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

void multiply_base(const PaddedMatrix& matrix, const Vector3* x, Vector3* y) {
  multiply_body(matrix, x, y);
}
#if defined(__x86_64__)
__attribute__((target("avx2"))) void multiply_avx2(const PaddedMatrix& matrix, const Vector3* x, Vector3* y) {
  multiply_body(matrix, x, y);
}
#endif

using Multiply = void (*)(const PaddedMatrix&, const Vector3*, Vector3*);

Multiply best() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return multiply_avx2;
#endif
  return multiply_base;
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
  kernel(matrix, x, y);
}

}  // namespace hariko
