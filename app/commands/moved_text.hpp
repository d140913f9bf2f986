#pragma once

// Line about a model that was moved to the origin when it was written. Internal to app/commands.

#include <string>

#include "core/base/vector.hpp"

namespace hariko {

/// Line "moved to zero by -x -y -z" in the file's numbers; empty where nothing moved.
std::string moved_text(const Vector3& moved);

}  // namespace hariko
