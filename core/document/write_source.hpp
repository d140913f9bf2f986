#pragma once

// Writing Bezier patches, solids, sections and outlines into the text of a document.

#include "core/document/document_text.hpp"

namespace hariko::detail {

void write_source(DocumentText& out, const BezierSource& source);
void write_source(DocumentText& out, const SolidsSource& source);
void write_source(DocumentText& out, const SkinSource& source);
void write_source(DocumentText& out, const OutlineSource& source);

}  // namespace hariko::detail
