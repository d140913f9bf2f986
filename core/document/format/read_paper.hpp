#pragma once

// Reading a paper model from the JSON of a document.

#include "core/document/format/json_cursor.hpp"
#include "core/document/paper_model.hpp"

namespace hariko::detail {

/// Reads a paper model. `text` is the whole file, from which unknown members are kept.
PaperModel read_paper(JsonReader& reader, const JsonCursor& at, std::string_view text);

}  // namespace hariko::detail
