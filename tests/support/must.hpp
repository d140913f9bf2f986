#pragma once

// must and must_fail: the test ends where a step on its way fails, or does not, and says why.

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/base/result.hpp"

namespace hariko::test {

/// The result of what has to succeed; where it does not the test fails with the message, at the line of the
/// call, and ends.
template <class T>
Result<T> must(Result<T> result, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (!result.ok()) {
    ADD_FAILURE_AT(file, line) << to_string(result.error());
    throw std::runtime_error("a step on the way failed");
  }
  return result;
}

/// Expects a refusal with this code. Any other result makes the test fail, at the line of the call, and end.
template <class T>
void must_fail(const Result<T>& result, Code code, const char* file = __builtin_FILE(),
               int line = __builtin_LINE()) {
  if (result.ok()) {
    ADD_FAILURE_AT(file, line) << "no refusal with " << code.name;
    throw std::runtime_error("nothing was refused");
  }
  if (!(result.error().code == code))
    ADD_FAILURE_AT(file, line) << to_string(result.error()) << " instead of " << code.name;
}

}  // namespace hariko::test
