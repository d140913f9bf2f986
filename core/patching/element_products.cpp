#include "core/patching/element_products.hpp"

#include "core/base/assert.hpp"

namespace hariko {

namespace {

typedef double Pair __attribute__((vector_size(16)));

inline Pair load(const double* from) {
  Pair out;
  __builtin_memcpy(&out, from, sizeof out);
  return out;
}

inline void add_to(double* to, Pair sum) {
  sum += load(to);
  __builtin_memcpy(to, &sum, sizeof sum);
}

/// Sum of products of `count` pairs.
template <std::size_t count>
inline Pair tree(const double* a, const double* b) {
  if constexpr (count == 1)
    return load(a) * load(b);
  else
    return tree<count / 2>(a, b) + tree<count - count / 2>(a + 2 * (count / 2), b + 2 * (count / 2));
}

template <std::size_t inner>
void add_dot_products(std::size_t rows, const double* a, const double* b, double* out) {
  for (std::size_t column = 0; column < 3; ++column, b += inner, out += rows)
    for (std::size_t i = 0; i < rows; ++i) {
      const Pair sum = tree<inner / 2>(a + i * inner, b);
      out[i] += sum[0] + sum[1];
    }
}

}  // namespace

void add_product(std::size_t rows, std::size_t inner, const double* a, const double* b, double* out) {
  const double *bx = b, *by = b + inner, *bz = b + 2 * inner;
  double *x = out, *y = out + rows, *z = out + 2 * rows;
  std::size_t i = 0;
  for (; i + 4 <= rows; i += 4) {
    Pair x0{}, x1{}, y0{}, y1{}, z0{}, z1{};
    const double* column = a + i;
    for (std::size_t k = 0; k < inner; ++k, column += rows) {
      const Pair p = load(column), q = load(column + 2);
      x0 += p * bx[k];
      x1 += q * bx[k];
      y0 += p * by[k];
      y1 += q * by[k];
      z0 += p * bz[k];
      z1 += q * bz[k];
    }
    add_to(x + i, x0);
    add_to(x + i + 2, x1);
    add_to(y + i, y0);
    add_to(y + i + 2, y1);
    add_to(z + i, z0);
    add_to(z + i + 2, z1);
  }
  for (; i + 2 <= rows; i += 2) {
    Pair x0{}, y0{}, z0{};
    const double* column = a + i;
    for (std::size_t k = 0; k < inner; ++k, column += rows) {
      const Pair p = load(column);
      x0 += p * bx[k];
      y0 += p * by[k];
      z0 += p * bz[k];
    }
    add_to(x + i, x0);
    add_to(y + i, y0);
    add_to(z + i, z0);
  }
  for (; i < rows; ++i) {
    double x0 = 0, y0 = 0, z0 = 0;
    const double* column = a + i;
    for (std::size_t k = 0; k < inner; ++k, column += rows) {
      x0 += *column * bx[k];
      y0 += *column * by[k];
      z0 += *column * bz[k];
    }
    x[i] += x0;
    y[i] += y0;
    z[i] += z0;
  }
}

void add_transposed_product(std::size_t rows, std::size_t inner, const double* a, const double* b,
                            double* out) {
  HARIKO_ASSERT(inner == 6 || inner == 18, "jumps or control points");
  if (inner == 6)
    add_dot_products<6>(rows, a, b, out);
  else
    add_dot_products<18>(rows, a, b, out);
}

}  // namespace hariko
