#pragma once

// Reading scenes of solids from JSON: as sources of documents, and as separate files.

#include <string_view>

#include "core/document/format/json_cursor.hpp"
#include "core/envelope/solid.hpp"

namespace hariko {

/// Reads a separate scene file: {"primitives": [{"type": "box", "size": [1, 1, 1], "position": ...,
/// "rotation": ...}], "roundness": 0.5, ...}; angles in degrees. Default roundness 0.5. Errors: E_LIMIT,
/// E_PARSE, E_SCHEMA, and those of `check_envelope`.
Result<EnvelopeInput> read_scene(std::string_view text);

namespace detail {

/// Reads the members of a scene within an object that may have others.
EnvelopeInput read_solids(JsonReader& reader, const JsonCursor& at);

}  // namespace detail

}  // namespace hariko
