#pragma once

// Reading one value from a text that contains nothing else.

#include <string_view>

#include "core/document/format/json_cursor.hpp"

namespace hariko::detail {

/// Calls read(reader, cursor) for the object that `text` contains. Errors: E_LIMIT, E_PARSE, E_SCHEMA, and
/// those of `read`.
template <class T, class Read>
Result<T> read_text(std::string_view text, Read&& read) {
  const Result<JsonValue> root = parse_json(text);
  if (!root) return root.error();
  JsonReader reader;
  const JsonCursor at(*root);
  if (!reader.is_object(at)) return reader.error();
  T value = read(reader, at);
  if (reader.failed()) return reader.error();
  return value;
}

}  // namespace hariko::detail
