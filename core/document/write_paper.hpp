#pragma once

// Writing a paper model into the text of a document.

#include "core/document/json_writer.hpp"
#include "core/document/paper_model.hpp"

namespace hariko::detail {

void write_paper(JsonWriter& out, const PaperModel& paper);

}  // namespace hariko::detail
