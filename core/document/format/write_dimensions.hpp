#pragma once

// Writing dimensions into the text of a document.

#include "core/document/dimension.hpp"
#include "core/document/format/document_text.hpp"

namespace hariko::detail {

/// Writes the document's member "dimensions", one line for each; nothing where there are none.
void write_dimensions(DocumentText& out, const Dimensions& dimensions);

}  // namespace hariko::detail
