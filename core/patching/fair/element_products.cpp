#include "core/patching/fair/element_products.hpp"

#include "core/base/assert.hpp"

#define HARIKO_INLINE inline __attribute__((always_inline))

namespace hariko {

namespace {

/// Four doubles; the compiler maps them to one AVX or two SSE registers.
typedef double Lane4 __attribute__((vector_size(32)));

/// Adds the sums of the last `lanes` lanes of four rows.
HARIKO_INLINE void add_lanes(double* to, const Lane4& sum, std::size_t lanes) {
  if (lanes == 4) {
    Lane4 all;
    __builtin_memcpy(&all, to, sizeof all);
    all += sum;
    __builtin_memcpy(to, &all, sizeof all);
  } else {
    for (std::size_t i = 4 - lanes; i < 4; ++i) to[i] += sum[i];
  }
}

HARIKO_INLINE void add_product_body(std::size_t rows, std::size_t inner, const double* a, const double* b,
                                    double* out) {
  const double *bx = b, *by = b + inner, *bz = b + 2 * inner;
  double *x = out, *y = out + rows, *z = out + 2 * rows;
  std::size_t i = 0;
  for (; i + 8 <= rows; i += 8) {
    Lane4 x0{}, x1{}, y0{}, y1{}, z0{}, z1{};
    const double* column = a + i;
    for (std::size_t k = 0; k < inner; ++k, column += rows) {
      Lane4 p, q;
      __builtin_memcpy(&p, column, sizeof p);
      __builtin_memcpy(&q, column + 4, sizeof q);
      x0 += p * bx[k];
      x1 += q * bx[k];
      y0 += p * by[k];
      y1 += q * by[k];
      z0 += p * bz[k];
      z1 += q * bz[k];
    }
    add_lanes(x + i, x0, 4);
    add_lanes(x + i + 4, x1, 4);
    add_lanes(y + i, y0, 4);
    add_lanes(y + i + 4, y1, 4);
    add_lanes(z + i, z0, 4);
    add_lanes(z + i + 4, z1, 4);
  }
  while (i < rows && rows >= 4) {
    const std::size_t lanes = rows - i < 4 ? rows - i : 4;
    i += lanes;
    const std::size_t first = i - 4;  // rows before i - lanes are summed again and discarded
    Lane4 x0{}, y0{}, z0{};
    const double* column = a + first;
    for (std::size_t k = 0; k < inner; ++k, column += rows) {
      Lane4 p;
      __builtin_memcpy(&p, column, sizeof p);
      x0 += p * bx[k];
      y0 += p * by[k];
      z0 += p * bz[k];
    }
    add_lanes(x + first, x0, lanes);
    add_lanes(y + first, y0, lanes);
    add_lanes(z + first, z0, lanes);
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

void add_product_base(std::size_t rows, std::size_t inner, const double* a, const double* b, double* out) {
  add_product_body(rows, inner, a, b, out);
}
#if defined(__x86_64__)
__attribute__((target("avx2"))) void add_product_avx2(std::size_t rows, std::size_t inner, const double* a,
                                                      const double* b, double* out) {
  add_product_body(rows, inner, a, b, out);
}
#endif

using AddProduct = void (*)(std::size_t rows, std::size_t inner, const double* a, const double* b,
                            double* out);

/// Fastest variant for the processor. All variants do the same additions and multiplications in the same
/// order.
AddProduct fastest_add_product() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return add_product_avx2;
#endif
  return add_product_base;
}

typedef double Pair __attribute__((vector_size(16)));

inline Pair load(const double* from) {
  Pair out;
  __builtin_memcpy(&out, from, sizeof out);
  return out;
}

/// Sum of the products of `count` pairs, as a balanced tree.
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
  static const AddProduct fastest = fastest_add_product();
  fastest(rows, inner, a, b, out);
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
