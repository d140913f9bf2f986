#pragma once

// Reading scenes of solids from separate files.

#include <string_view>

#include "core/envelope/solid.hpp"

namespace hariko {

/// Reads a separate scene file: {"primitives": [{"type": "box", "size": [1, 1, 1], "position": ...,
/// "rotation": ...}], "roundness": 0.5, ...}; angles in degrees. Default roundness 0.5. Errors: E_LIMIT,
/// E_PARSE, E_SCHEMA, and those of `check_envelope`.
Result<EnvelopeInput> read_scene(std::string_view text);

}  // namespace hariko
