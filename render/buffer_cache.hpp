#pragma once

// BufferCache: GPU copies of values, shared by pictures. Internal to render/.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace hariko::gl {

/// Cache of GPU copies, keyed by the value's address. Copies that no picture uses are dropped.
template <class Value, class Buffers>
class BufferCache {
 public:
  /// GPU copy of a value, uploaded on first use, and marked as used by the picture. `uploaded` grows by the
  /// bytes.
  Buffers& get(const std::shared_ptr<const Value>& value, unsigned picture_bit, std::size_t& uploaded) {
    auto entry =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.value == value; });
    if (entry == entries_.end())
      entry = entries_.insert(entries_.end(), {value, std::make_unique<Buffers>(*value, uploaded)});
    entry->used_by |= picture_bit;
    return *entry->buffers;
  }
  /// Removes the marks of pictures.
  void release(unsigned picture_bits) {
    for (Entry& entry : entries_) entry.used_by &= ~picture_bits;
  }
  /// Frees the copies that no picture uses.
  void drop_unused() {
    std::erase_if(entries_, [](const Entry& entry) { return entry.used_by == 0; });
  }

 private:
  struct Entry {
    std::shared_ptr<const Value> value;  // kept so that its address stays unique
    std::unique_ptr<Buffers> buffers;
    unsigned used_by = 0;  // one bit for each picture
  };
  std::vector<Entry> entries_;
};

}  // namespace hariko::gl
