#pragma once

// PointWelder: joins equal positions to one index. Internal to core/exchange.

#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Open-addressing hash table over a growing list of positions. 0 and -0 are equal. Expected time O(1) a
/// point.
class PointWelder {
 public:
  explicit PointWelder(std::size_t expected_points);
  /// Index of the position, which must be finite; a new position is appended.
  Index add(Vector3 position);
  /// Prefetches the slot that `add` will look at, as a large table is not in the cache. Any numbers are
  /// allowed.
  void expect(Vector3 position) const;
  /// Hands out the positions, by index.
  std::vector<Vector3> take_positions() { return std::move(positions_); }
  std::size_t size() const { return positions_.size(); }

 private:
  void grow();
  std::vector<Vector3> positions_;
  std::vector<Index> slots_;  ///< size a power of two; at most half full; no_index = free
};

}  // namespace hariko
