#pragma once

// The line about a model that was moved to zero as it was written. Internal to app/commands.

#include <string>

#include "core/base/vector.hpp"

namespace hariko {

/// "moved to zero by -x -y -z", a line, in the file's numbers; empty where nothing moved.
std::string moved_text(const Vector3& moved);

}  // namespace hariko
