#pragma once

// SharedMemory: memory use of a set of documents, with shared blocks counted once.

#include <cstddef>
#include <functional>
#include <unordered_map>

#include "core/document/document.hpp"

namespace hariko {

/// Counts blocks by address and number of users. Sizes are those of the arrays plus an allowance for each
/// block, within about 10 % of the allocator's.
class SharedMemory {
 public:
  /// Adds a document. O(objects), plus O(vertices / 128) for each object not counted yet.
  void add(const Document& document);
  /// Removes a document, which must have been added before.
  void remove(const Document& document);
  std::size_t bytes() const { return bytes_; }

 private:
  struct Block {
    std::size_t users = 0;
    std::size_t bytes = 0;
  };
  /// Returns true when the block was not counted before (add) or no longer is (remove).
  bool enter(const void* address, std::size_t bytes);
  bool leave(const void* address);

  std::unordered_map<const void*, Block> blocks_;
  std::size_t bytes_ = 0;
};

}  // namespace hariko
