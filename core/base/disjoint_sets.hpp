#pragma once

// DisjointSets: union-find.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/index_list.hpp"

namespace hariko {

/// Disjoint sets of items 0 .. size - 1. The least item of a set represents it, whatever the order of the
/// joins. `find` and `join` take O(log n) a call on average.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count = 0) : parent_(ascending_indices(count)) {}

  std::size_t size() const { return parent_.size(); }
  /// Adds an item, alone in its set.
  Index add() {
    parent_.push_back(static_cast<Index>(parent_.size()));
    return parent_.back();
  }
  /// Representative of an item's set.
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Merges the sets of two items.
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace hariko
