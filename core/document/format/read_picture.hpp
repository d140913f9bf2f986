#pragma once

// Reading a reference picture from the JSON of a document.

#include "core/document/format/json_cursor.hpp"
#include "core/document/picture_source.hpp"

namespace hariko::detail {

/// Reads the known members; the caller keeps the unknown ones.
PictureSource read_picture(JsonReader& reader, const JsonCursor& at);

}  // namespace hariko::detail
