#pragma once

// Writing a paper model into the text of a document.

#include "core/document/format/document_text.hpp"
#include "core/document/paper_model.hpp"

namespace hariko::detail {

/// Writes the value of the document's member "paper".
void write_paper(DocumentText& out, const PaperModel& paper);

}  // namespace hariko::detail
