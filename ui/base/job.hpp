#pragma once

// Job: long work that the status line shows, with how far it is, and a way to stop it.

#include <algorithm>
#include <string>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"

namespace hariko {

struct Job {
  std::string text;  ///< "Exporting vase.obj", in English
  bool can_be_cancelled = false;
  CancelToken cancel;
  Progress progress;
};

/// Whole percents for showing; 0 while nothing is known.
inline int percent_of(const Job& job) {
  return static_cast<int>(100 * std::max(0.0, job.progress.fraction()));
}

}  // namespace hariko
