#pragma once

// Reading the sources of objects from JSON.

#include <optional>
#include <span>

#include "core/document/format/json_cursor.hpp"
#include "core/document/source.hpp"

namespace hariko::detail {

/// Largest id in files.
inline constexpr std::uint32_t max_id = no_index - 1;

/// Reads a source. `text` is the whole file, from which unknown members are kept.
std::optional<Source> read_source(JsonReader& reader, const JsonCursor& at, std::string_view text);

/// Members of an object that are not among `known`, with their text unchanged.
KeptMembers kept_members(const JsonCursor& at, std::span<const std::string_view> known,
                         std::string_view text);
/// Reports E_SCHEMA at the first unknown member, where none can be kept.
void refuse_unknown_members(JsonReader& reader, const JsonCursor& at,
                            std::span<const std::string_view> known);

}  // namespace hariko::detail
