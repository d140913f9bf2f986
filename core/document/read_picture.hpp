#pragma once

// Reading a reference picture from the JSON of a document.

#include "core/document/json_cursor.hpp"
#include "core/document/picture_source.hpp"

namespace hariko::detail {

/// The members but those that are kept.
PictureSource read_picture(JsonReader& reader, const JsonCursor& at);

}  // namespace hariko::detail
