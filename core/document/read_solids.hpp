#pragma once

// Scenes of solids from JSON: as sources of documents, and as files of their own.

#include <string_view>

#include "core/document/json_cursor.hpp"
#include "core/envelope/solid.hpp"

namespace hariko {

/// A scene's own layout: {"primitives": [{"type": "box", "size": [1, 1, 1], "position": ..., "rotation":
/// ...}], "roundness": 0.5, ...}; angles in degrees. Where the file says no roundness, it is 0.5. Errors:
/// E_LIMIT, E_PARSE, E_SCHEMA, and those of `check_envelope`.
Result<EnvelopeInput> read_scene(std::string_view text);

namespace detail {

/// The members of a scene within an object that may have others.
EnvelopeInput read_solids(JsonReader& reader, const JsonCursor& at);

}  // namespace detail

}  // namespace hariko
