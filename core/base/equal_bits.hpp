#pragma once

// Comparison of numbers bit for bit, for results that are kept only where the same input would give them
// again.

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/base/vector.hpp"

namespace hariko {

/// Whether two numbers have the same bits: other than for ==, 0 and -0 differ, and a NaN equals itself.
inline bool equal_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Whether two vectors or matrices of one fixed size have the same bits.
template <class Matrix>
bool equal_bits(const Eigen::PlainObjectBase<Matrix>& a, const Eigen::PlainObjectBase<Matrix>& b) {
  return std::equal(a.data(), a.data() + a.size(), b.data(),
                    [](double x, double y) { return equal_bits(x, y); });
}

}  // namespace hariko
