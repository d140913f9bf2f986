#pragma once

// Writing Bezier patches, solids, sections and outlines into the text of a document.

#include "core/document/json_writer.hpp"

namespace hariko::detail {

void write_source(JsonWriter& out, const BezierSource& source);
void write_source(JsonWriter& out, const SolidsSource& source);
void write_source(JsonWriter& out, const SkinSource& source);
void write_source(JsonWriter& out, const OutlineSource& source);

}  // namespace hariko::detail
