#pragma once

// What a JSON file holds, told by its content: the ending .json says nothing.

#include <filesystem>
#include <string_view>

#include "core/base/result.hpp"

namespace hariko {

enum class JsonKind { document, patches, scene, skin, outline, keys, layout };

/// The kind by its marks: a member "format" for those that have one, objects with "ctrl" for patches, else
/// the members of the whole. E_PARSE where the text is no JSON; E_FORMAT_UNKNOWN where no kind has such
/// marks, with the kinds that this program takes. Other kinds are entries in a table (json_kind.cpp).
Result<JsonKind> json_kind(std::string_view text);

/// What a kind is called in messages: "key bindings".
std::string_view name_of(JsonKind kind);
/// How such a file is used when it cannot be opened; empty for those that can.
std::string_view use_of(JsonKind kind);

}  // namespace hariko
