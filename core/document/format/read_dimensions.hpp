#pragma once

// Reading dimensions from the JSON of a document.

#include "core/document/dimension.hpp"
#include "core/document/format/json_cursor.hpp"

namespace hariko::detail {

/// Reads the value of the document's member "dimensions". What anchors name need not exist.
Dimensions read_dimensions(JsonReader& reader, const JsonCursor& at);

}  // namespace hariko::detail
