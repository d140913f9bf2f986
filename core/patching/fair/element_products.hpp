#pragma once

// Products of small matrices with three right-hand sides: the inner loops of mode FAIR's solver. Sizes are
// arguments, not template parameters: a template for each of its two dozen shapes takes longer to compile
// than the rest of the solver.

#include <cstddef>

namespace hariko {

/// Adds a product: out += a b. a: rows x inner; b: inner x 3; out: rows x 3; all in column-major order. Sums
/// ascend by the inner index.
void add_product(std::size_t rows, std::size_t inner, const double* a, const double* b, double* out);

/// Adds a transposed product: out += a^T b. a: inner x rows, inner 6 or 18; otherwise as above. Even and odd
/// places are summed separately, each as a balanced tree.
void add_transposed_product(std::size_t rows, std::size_t inner, const double* a, const double* b,
                            double* out);

}  // namespace hariko
