#pragma once

// Reading skins from JSON: the members of a document's source, and the plain layout for sections drawn in
// other programs (points of sections and path as rows of numbers, links and merges by strip and indices).

#include <string_view>

#include "core/document/format/json_cursor.hpp"
#include "core/skinning/skin.hpp"

namespace hariko::detail {

/// Reads the skin of an object; missing ids are numbered. Only types and sizes are checked here, everything
/// else by `plan_skin`. A link or merge of the plain layout whose strip or point does not exist is E_INDEX.
Skin read_skin(JsonReader& reader, const JsonCursor& at);

}  // namespace hariko::detail

namespace hariko {

/// Reads a skin from text in the plain layout; sections are reversed where needed so that all have the same
/// direction (see `turn_sections`). Errors: E_LIMIT, E_PARSE, E_SCHEMA, E_INDEX.
Result<Skin> read_skin_layout(std::string_view text);

}  // namespace hariko
