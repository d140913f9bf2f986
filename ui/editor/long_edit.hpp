#pragma once

// LongEdit: an edit that takes too long for the event loop.

#include <functional>
#include <string>

#include "core/base/cancellation.hpp"
#include "core/base/ids.hpp"
#include "core/base/progress.hpp"

namespace hariko {

/// Work that an edit of one object begins with, and what makes the step of it.
struct LongEdit {
  using Then = std::function<void()>;
  std::string what;  ///< "Fitting Body", in English
  ObjectId object;
  /// Computes from values alone, as it may run on another thread, and returns soon when it is cancelled.
  /// Work of the worker; returns a function, never empty, that is called on the main thread unless cancelled.
  std::function<Then(const CancelToken&, const Progress&)> work;
};

}  // namespace hariko
