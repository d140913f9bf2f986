#pragma once

// Reading a paper model from the JSON of a document.

#include "core/document/json_cursor.hpp"
#include "core/document/paper_model.hpp"

namespace hariko::detail {

/// `text` is the whole file, of which unknown parts are kept.
PaperModel read_paper(JsonReader& reader, const JsonCursor& at, std::string_view text);

}  // namespace hariko::detail
