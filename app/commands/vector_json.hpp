#pragma once

// Vectors in what commands print. Internal to app/commands.

#include <nlohmann/json_fwd.hpp>

#include "core/base/vector.hpp"

namespace hariko {

/// [x, y, z]
nlohmann::ordered_json vector_json(const Vector3& v);

}  // namespace hariko
