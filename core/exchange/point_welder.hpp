#pragma once

// PointWelder: one number for each distinct position. Internal to core/exchange.

#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// An open hash table over a growing list of positions. 0 and -0 are equal. Expected time O(1) a point.
class PointWelder {
 public:
  explicit PointWelder(std::size_t expected_points);
  /// Number of the position, which must be finite; a new one is appended.
  Index add(Vector3 position);
  /// Fetches what `add` will look at: a table of many points is farther away than all else. Any numbers.
  void expect(Vector3 position) const;
  std::vector<Vector3> take_positions() { return std::move(positions_); }
  std::size_t size() const { return positions_.size(); }

 private:
  void grow();
  std::vector<Vector3> positions_;
  std::vector<Index> slots_;  ///< power of two; at most half full; no_index = free
};

}  // namespace hariko
