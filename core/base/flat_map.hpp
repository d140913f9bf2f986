#pragma once

// FlatMap: a small sorted map as a value, for per-element settings that most elements do not have.

#include <algorithm>
#include <utility>
#include <vector>

namespace hariko {

template <class Key, class Value>
class FlatMap {
 public:
  using Entry = std::pair<Key, Value>;

  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  auto begin() const { return entries_.begin(); }
  auto end() const { return entries_.end(); }

  /// Value of a key, null where it has none. O(log size).
  const Value* find(const Key& key) const {
    const auto it = lower(key);
    return it != entries_.end() && it->first == key ? &it->second : nullptr;
  }
  bool contains(const Key& key) const { return find(key) != nullptr; }
  Value get_or(const Key& key, Value fallback) const {
    const Value* found = find(key);
    return found ? *found : fallback;
  }
  /// Inserts or replaces. O(size) when the key is new.
  void set(const Key& key, Value value) {
    const auto it = entries_.begin() + (lower(key) - entries_.begin());
    if (it != entries_.end() && it->first == key)
      it->second = std::move(value);
    else
      entries_.insert(it, {key, std::move(value)});
  }
  /// Removes a key, if it is there. O(size).
  void erase(const Key& key) {
    const auto it = entries_.begin() + (lower(key) - entries_.begin());
    if (it != entries_.end() && it->first == key) entries_.erase(it);
  }

  friend bool operator==(const FlatMap&, const FlatMap&) = default;

 private:
  auto lower(const Key& key) const {
    return std::lower_bound(entries_.begin(), entries_.end(), key,
                            [](const Entry& entry, const Key& k) { return entry.first < k; });
  }
  std::vector<Entry> entries_;
};

}  // namespace hariko
