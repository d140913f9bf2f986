#pragma once

// Lists of indices and names: numbered in order, sorted into sets, and closed lists without repetitions.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Indices first, first + 1 ... in ascending order; `count` of them. O(count).
inline std::vector<Index> ascending_indices(std::size_t count, Index first = 0) {
  std::vector<Index> out(count);
  std::iota(out.begin(), out.end(), first);
  return out;
}

/// Indices 0 .. count - 1 in the order of a comparison: before(a, b) tells whether `a` comes before `b`.
/// Indices of equal rank ascend. O(n log n).
template <class Before>
std::vector<Index> stable_order(std::size_t count, const Before& before) {
  std::vector<Index> out = ascending_indices(count);
  std::stable_sort(out.begin(), out.end(), before);
  return out;
}

/// Sorts a list and removes repetitions, which makes it a set that can be searched by bisection. O(n log n).
template <class Value>
void sort_unique(std::vector<Value>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Removes the entries of a closed list that equal the one before them: of a run of equal ones the first
/// stays, and of equal ones at both ends of the list that at its beginning. Lists of equal entries keep one.
/// O(n).
template <class Value>
void remove_repeats(std::vector<Value>& loop) {
  loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
  while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
}

}  // namespace hariko
