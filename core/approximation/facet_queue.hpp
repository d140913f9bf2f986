#pragma once

// The facets that refinement is still to cut, those with the largest errors first.

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// While there are few facets they come strictly by their errors. When there are many, those whose errors are
/// within a factor of two of each other come the last first, those that were there before one neighbourhood
/// after the other: what is cut together then lies together in memory.
class FacetQueue {
 public:
  struct Entry {
    double error = 1;  ///< relative to the tolerance, at least 1
    Index facet = no_index;
    std::uint32_t version = 0;
  };
  /// `place`: a number for each facet that is there, near for facets that are near each other.
  explicit FacetQueue(std::function<std::uint64_t(Index)> place) : place_(std::move(place)) {}

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  /// O(log n) while there are few, else O(1).
  void push(const Entry& entry);
  /// The queue is not empty (asserted).
  Entry pop();

 private:
  void pour();

  std::function<std::uint64_t(Index)> place_;
  std::vector<Entry> heap_;
  std::vector<std::vector<Entry>> octaves_;  ///< by the error's exponent; none while the heap is in use
  std::size_t highest_ = 0;                  ///< no octave above it has entries
  std::size_t size_ = 0;
};

}  // namespace hariko
