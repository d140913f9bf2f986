#pragma once

// Kinds of JSON files, recognised by content because the ending .json does not tell.

#include <filesystem>
#include <string_view>

#include "core/base/result.hpp"

namespace hariko {

/// Kinds of JSON files that this program writes or reads.
enum class JsonKind { document, patches, scene, skin, outline, keys, layout };

/// Kind of a JSON text: by its member "format", by objects with "ctrl" for patches, otherwise by its
/// top-level members. Kinds are entries of a table (detect_json_format.cpp). Errors: E_PARSE where the text
/// is not JSON; E_FORMAT_UNKNOWN, listing the kinds that this program takes, where no kind matches. O(size).
Result<JsonKind> json_kind(std::string_view text);

/// Name of a kind in messages: "key bindings".
std::string_view name_of(JsonKind kind);
/// Advice on how to use a file that cannot be opened; empty for kinds that can.
std::string_view use_of(JsonKind kind);

}  // namespace hariko
