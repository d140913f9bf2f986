#include "core/surface/tensor_sums.hpp"

namespace hariko {

namespace {

/// Positions for degrees known at compile time, with loops that the compiler unrolls.
template <int p, int q>
void fixed_positions(const Vector3* control, std::span<const Vector2> parameters, std::span<Vector3> out) {
  double rows[q + 1][3];
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    BernsteinValues s, t;
    bernstein(p, parameters[k].x(), 1 - parameters[k].x(), s);
    bernstein(q, parameters[k].y(), 1 - parameters[k].y(), t);
    for (std::size_t j = 0; j <= q; ++j)
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3* c = control + j * (p + 1);
        double sum = s[0] * c[0][axis] + s[p] * c[p][axis];
        for (std::size_t i = 1; i + i < p; ++i) sum += s[i] * c[i][axis] + s[p - i] * c[p - i][axis];
        if constexpr (p % 2 == 0) sum += s[p / 2] * c[p / 2][axis];
        rows[j][axis] = sum;
      }
    for (int axis = 0; axis < 3; ++axis) {
      double sum = t[0] * rows[0][axis] + t[q] * rows[q][axis];
      for (std::size_t j = 1; j + j < q; ++j) sum += t[j] * rows[j][axis] + t[q - j] * rows[q - j][axis];
      if constexpr (q % 2 == 0) sum += t[q / 2] * rows[q / 2][axis];
      out[k][axis] = sum;
    }
  }
}

}  // namespace

void tensor_positions(int p, int q, const Vector3* control, std::span<const Vector2> parameters,
                      std::span<Vector3> out) {
  if (p == 3 && q == 3) {
    fixed_positions<3, 3>(control, parameters, out);
    return;
  }
  BernsteinValues s, t;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    bernstein(p, parameters[k].x(), 1 - parameters[k].x(), s);
    bernstein(q, parameters[k].y(), 1 - parameters[k].y(), t);
    out[k] = tensor_sum(p, q, s, t, control);
  }
}

}  // namespace hariko
