#pragma once

// SkinWork: cancellation, progress and cache of a skin's evaluation.

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"

namespace hariko {

class ColumnCache;

struct SkinWork {
  CancelToken cancel = {};
  /// Progress of the search for columns, the only slow part. Nothing is reported where no search is needed.
  Progress progress = {};
  /// In the middle of a drag: columns found before stay where they are on sections that move.
  bool moving = false;
  /// Cache of earlier results; may be null.
  ColumnCache* columns = nullptr;
};

}  // namespace hariko
