#pragma once

// Result<T>: a value, or the error message that says why there is none. For failures that a user can cause;
// failures that only a programmer can cause are assertions.

#include <optional>
#include <utility>
#include <variant>

#include "core/base/assert.hpp"
#include "core/base/message.hpp"

namespace hariko {

/// Value of type T, or the error message that says why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}        // NOLINT: implicit on purpose
  Result(Message error) : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit on purpose

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  const T& value() const& {
    HARIKO_ASSERT(ok(), "value() of a failed result");
    return std::get<0>(state_);
  }
  T& value() & {
    HARIKO_ASSERT(ok(), "value() of a failed result");
    return std::get<0>(state_);
  }
  T&& value() && {
    HARIKO_ASSERT(ok(), "value() of a failed result");
    return std::get<0>(std::move(state_));
  }
  const Message& error() const {
    HARIKO_ASSERT(!ok(), "error() of a good result");
    return std::get<1>(state_);
  }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }

 private:
  std::variant<T, Message> state_;
};

/// Value of a function that has no result but may fail: Result<Done>.
struct Done {};

}  // namespace hariko
