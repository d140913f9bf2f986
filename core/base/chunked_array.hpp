#pragma once

// ChunkedArray: an array as a value whose copies share unchanged chunks. Editing one element of a copy copies
// one chunk, so a history of thousands of small edits costs little memory.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/assert.hpp"

namespace hariko {

/// Array of chunks of `ChunkSize` elements, which copies share until they edit them.
template <class T, std::size_t ChunkSize>
class ChunkedArray {
 public:
  ChunkedArray() = default;
  explicit ChunkedArray(std::size_t count, const T& value = T{}) : size_(count) {
    for (std::size_t begin = 0; begin < count; begin += ChunkSize)
      chunks_.push_back(std::make_shared<std::vector<T>>(std::min(ChunkSize, count - begin), value));
  }
  explicit ChunkedArray(const std::vector<T>& values) : size_(values.size()) {
    for (std::size_t begin = 0; begin < size_; begin += ChunkSize) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto last = values.begin() + static_cast<std::ptrdiff_t>(std::min(size_, begin + ChunkSize));
      chunks_.push_back(std::make_shared<std::vector<T>>(first, last));
    }
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  const T& operator[](std::size_t i) const {
    HARIKO_ASSERT(i < size_, "index out of range");
    return (*chunks_[i / ChunkSize])[i % ChunkSize];
  }

  /// Reference for writing; copies the chunk first when another value shares it. Not thread-safe.
  T& edit(std::size_t i) {
    HARIKO_ASSERT(i < size_, "index out of range");
    auto& chunk = chunks_[i / ChunkSize];
    if (chunk.use_count() > 1) chunk = std::make_shared<std::vector<T>>(*chunk);
    return (*chunk)[i % ChunkSize];
  }

  /// True when element i of both arrays lies in the same shared memory, hence is equal without comparing.
  bool shares(const ChunkedArray& other, std::size_t i) const {
    return i < size_ && i < other.size_ && chunks_[i / ChunkSize] == other.chunks_[i / ChunkSize];
  }

  std::size_t chunk_count() const { return chunks_.size(); }
  /// Address of the memory of chunk c, for counting shared bytes.
  const void* chunk_address(std::size_t c) const { return chunks_[c].get(); }

  /// Copy of all elements. O(size).
  std::vector<T> to_vector() const {
    std::vector<T> out;
    out.reserve(size_);
    for (const auto& chunk : chunks_) out.insert(out.end(), chunk->begin(), chunk->end());
    return out;
  }

  friend bool operator==(const ChunkedArray& a, const ChunkedArray& b) {
    if (a.size_ != b.size_) return false;
    for (std::size_t c = 0; c < a.chunks_.size(); ++c)
      if (a.chunks_[c] != b.chunks_[c] && *a.chunks_[c] != *b.chunks_[c]) return false;
    return true;
  }

 private:
  std::size_t size_ = 0;
  std::vector<std::shared_ptr<std::vector<T>>> chunks_;
};

}  // namespace hariko
