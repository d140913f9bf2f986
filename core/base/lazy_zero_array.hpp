#pragma once

// ZeroedArray: a large array of numbers, initially zero, of which only a part may ever be touched.

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

#include "core/base/assert.hpp"

namespace hariko {

/// Lazily zeroed array. The operating system supplies zero pages on first touch, so untouched parts cost
/// neither time nor memory; `std::vector` would write them all. T consists of numbers for which zero bits
/// mean zero.
template <class T>
class ZeroedArray {
 public:
  static_assert(std::is_trivially_destructible_v<T>);

  ZeroedArray() = default;
  explicit ZeroedArray(std::size_t count) : size_(count) {
    if (count == 0) return;
    data_.reset(static_cast<T*>(std::calloc(count, sizeof(T))));
    if (!data_) throw std::bad_alloc();
  }

  std::size_t size() const { return size_; }
  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  T& operator[](std::size_t i) { return data_.get()[i]; }
  const T& operator[](std::size_t i) const { return data_.get()[i]; }
  std::span<T> span() { return {data(), size_}; }
  std::span<const T> span() const { return {data(), size_}; }

 private:
  struct Free {
    void operator()(T* p) const { std::free(p); }
  };
  std::unique_ptr<T[], Free> data_;
  std::size_t size_ = 0;
};

}  // namespace hariko
