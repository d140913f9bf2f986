#pragma once

// Job: long work that the status line shows, with how far it is, and a way to stop it.

#include <algorithm>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "ui/base/language.hpp"

namespace hariko {

struct Job {
  /// Kinds of work that a panel looks for.
  enum class Kind { other, placing_columns, unfolding };

  Phrase text;  ///< "Exporting vase.obj"
  bool can_be_cancelled = false;
  CancelToken cancel;
  Progress progress;
  Kind kind = Kind::other;
};

/// Whole percents for showing; 0 while nothing is known.
inline int percent_of(const Job& job) {
  return static_cast<int>(100 * std::max(0.0, job.progress.fraction()));
}

}  // namespace hariko
