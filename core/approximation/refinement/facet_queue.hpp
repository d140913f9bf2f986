#pragma once

// FacetQueue: the facets that refinement has still to cut, those with the largest errors first.

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Priority queue of facets. Few facets are kept strictly by their errors. Many facets are kept in octaves of
/// error, within which the last comes first and those present at the change lie in order of neighbourhood, so
/// that facets cut one after the other are close in memory.
class FacetQueue {
 public:
  struct Entry {
    double error = 1;  ///< relative to the tolerance, at least 1
    Index facet = no_index;
    std::uint32_t version = 0;
  };
  /// `place`: a number per existing facet that is close for facets close to each other.
  explicit FacetQueue(std::function<std::uint64_t(Index)> place) : place_(std::move(place)) {}

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  /// Adds an entry. O(log n) while there are few, otherwise O(1).
  void push(const Entry& entry);
  /// Removes the first entry. The queue is not empty (asserted).
  Entry pop();

 private:
  /// Moves all entries from the heap to the octaves.
  void pour();

  std::function<std::uint64_t(Index)> place_;
  std::vector<Entry> heap_;
  std::vector<std::vector<Entry>> octaves_;  ///< by the error's exponent; empty while the heap is in use
  std::size_t highest_ = 0;                  ///< no octave above it has entries
  std::size_t size_ = 0;
};

}  // namespace hariko
