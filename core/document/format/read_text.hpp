#pragma once

// Reading one value from a text that contains nothing else.

#include <string_view>

#include "core/document/format/archive.hpp"

namespace hariko::detail {

/// Calls read(archive, value) for the object that `text` contains; members that it does not ask for mean
/// nothing. Errors: E_LIMIT, E_PARSE, E_SCHEMA, and those of `read`.
template <class T, class Read>
Result<T> read_text(std::string_view text, Read&& read) {
  const Result<JsonValue> root = parse_json(text);
  if (!root) return root.error();
  JsonReader reader(text);
  const JsonCursor at(*root);
  if (!reader.is_object(at)) return reader.error();
  T value;
  ReadArchive archive(reader, at);
  read(archive, value);
  if (reader.failed()) return reader.error();
  return value;
}

}  // namespace hariko::detail
