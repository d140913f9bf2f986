#pragma once

// Reading the sources of objects from JSON.

#include <optional>
#include <span>

#include "core/document/json_cursor.hpp"
#include "core/document/source.hpp"

namespace hariko::detail {

/// Of ids in files.
inline constexpr std::uint32_t max_id = no_index - 1;

/// `text` is the whole file, of which unknown parts are kept.
std::optional<Source> read_source(JsonReader& reader, const JsonCursor& at, std::string_view text);

/// The members of an object that are not among `known`, as they are in the text.
KeptMembers kept_members(const JsonCursor& at, std::span<const std::string_view> known,
                         std::string_view text);
/// E_SCHEMA at the first such member: for places where nothing can be kept.
void refuse_unknown_members(JsonReader& reader, const JsonCursor& at,
                            std::span<const std::string_view> known);

}  // namespace hariko::detail
