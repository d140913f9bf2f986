#pragma once

// How the control mesh of a skin is computed.

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"

namespace hariko {

class ColumnMemory;

struct SkinWork {
  CancelToken cancel = {};
  /// Of the search for columns, which alone takes long. Nothing is reported where none is needed.
  Progress progress = {};
  /// In the middle of a drag: columns found before stay where they are on sections that move.
  bool moving = false;
  /// What earlier calls found; null: nothing is known.
  ColumnMemory* columns = nullptr;
};

}  // namespace hariko
