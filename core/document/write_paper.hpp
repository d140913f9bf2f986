#pragma once

// Writing a paper model into the text of a document.

#include "core/document/document_text.hpp"
#include "core/document/paper_model.hpp"

namespace hariko::detail {

void write_paper(DocumentText& out, const PaperModel& paper);

}  // namespace hariko::detail
