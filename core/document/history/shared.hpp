#pragma once

// Shared<T>: an immutable value shared by its copies, compared by value.

#include <memory>
#include <utility>

namespace hariko {

/// Shared value, never null. Copying costs a reference count; copies of one value compare equal without
/// comparing contents.
template <class T>
class Shared {
 public:
  Shared() : pointer_(std::make_shared<const T>()) {}
  Shared(T value) : pointer_(std::make_shared<const T>(std::move(value))) {}  // NOLINT: implicit on purpose

  const T& operator*() const { return *pointer_; }
  const T* operator->() const { return pointer_.get(); }
  const T* get() const { return pointer_.get(); }  ///< address, for counting shared bytes

  friend bool operator==(const Shared& a, const Shared& b) {
    return a.pointer_ == b.pointer_ || *a.pointer_ == *b.pointer_;
  }

 private:
  std::shared_ptr<const T> pointer_;
};

}  // namespace hariko
