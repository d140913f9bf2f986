#include "core/approximation/refinement/facet_queue.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Number of facets above which they are no longer kept in strict order: the heap, and access to facets
/// scattered over the memory, would take most of the time.
constexpr std::size_t most_in_order = 16'384;
constexpr std::size_t octave_count = 64;  ///< larger errors are in the last octave

bool later(const FacetQueue::Entry& a, const FacetQueue::Entry& b) {
  return a.error < b.error || (a.error == b.error && a.facet > b.facet);
}

std::size_t octave_of(double error) {
  const double last = double(octave_count - 1);
  return std::size_t(std::clamp(std::logb(error), 0.0, last));
}

}  // namespace

void FacetQueue::push(const Entry& entry) {
  ++size_;
  if (octaves_.empty()) {
    heap_.push_back(entry);
    std::push_heap(heap_.begin(), heap_.end(), later);
    if (heap_.size() > most_in_order) pour();
    return;
  }
  const std::size_t octave = octave_of(entry.error);
  octaves_[octave].push_back(entry);
  highest_ = std::max(highest_, octave);
}

FacetQueue::Entry FacetQueue::pop() {
  HARIKO_ASSERT(size_ > 0, "the queue is empty");
  --size_;
  if (octaves_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Entry top = heap_.back();
    heap_.pop_back();
    return top;
  }
  while (octaves_[highest_].empty()) --highest_;
  const Entry top = octaves_[highest_].back();
  octaves_[highest_].pop_back();
  return top;
}

void FacetQueue::pour() {
  std::vector<std::pair<std::uint64_t, Entry>> placed;
  placed.reserve(heap_.size());
  for (const Entry& entry : heap_) placed.emplace_back(place_(entry.facet), entry);
  std::sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) {
    return a.first < b.first ||
           (a.first == b.first && (a.second.facet < b.second.facet || (a.second.facet == b.second.facet &&
                                                                       a.second.version < b.second.version)));
  });
  octaves_.resize(octave_count);
  highest_ = 0;
  for (const auto& [place, entry] : placed) {
    const std::size_t octave = octave_of(entry.error);
    octaves_[octave].push_back(entry);
    highest_ = std::max(highest_, octave);
  }
  heap_ = {};
}

}  // namespace hariko
