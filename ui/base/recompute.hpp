#pragma once

// Recompute: when surfaces follow the polyhedra, and what the user asks of the rebuilding.

#include <set>

#include "core/base/ids.hpp"

namespace hariko {

/// At every change; when a drag is released; when the user says so.
enum class RecomputePolicy { live, on_release, manual };

struct Recompute {
  RecomputePolicy policy = RecomputePolicy::live;
  /// Asked for by commands, taken by the application.
  bool wants_cancel = false, wants_now = false;
  /// Written by the application: objects whose surface is not up to date and not on its way either.
  std::set<ObjectId> outdated;
};

}  // namespace hariko
