#pragma once

// Writing Bezier patches, solids, sections, outlines and pictures into the text of a document.

#include "core/document/format/document_text.hpp"

namespace hariko::detail {

/// Writes the value of an object's member "source".
void write_source(DocumentText& out, const BezierSource& source);
void write_source(DocumentText& out, const SolidsSource& source);
void write_source(DocumentText& out, const SkinSource& source);
void write_source(DocumentText& out, const OutlineSource& source);
void write_source(DocumentText& out, const PictureSource& source);

}  // namespace hariko::detail
