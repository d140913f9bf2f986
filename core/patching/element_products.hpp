#pragma once

// Small matrices times three right-hand sides: the inner loops of mode FAIR's solver. Sizes are arguments,
// not types: a template for each of its two dozen shapes takes longer to compile than the rest of the solver.

#include <cstddef>

namespace hariko {

/// out += a b. a: rows x inner; b: inner x 3; out: rows x 3; all a column after the other. Sums go up the
/// inner index.
void add_product(std::size_t rows, std::size_t inner, const double* a, const double* b, double* out);

/// out += a^T b. a: inner x rows, inner 6 or 18; otherwise as above. Even and odd places are summed apart,
/// each as the balanced tree of its halves.
void add_transposed_product(std::size_t rows, std::size_t inner, const double* a, const double* b,
                            double* out);

}  // namespace hariko
