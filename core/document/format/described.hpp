#pragma once

// Parts of a document that have a file of their own for their description; each is compiled once.

#include <optional>

#include "core/document/document.hpp"
#include "core/document/format/document_text.hpp"
#include "core/document/format/json_cursor.hpp"
#include "core/document/paper_model.hpp"

namespace hariko::detail {

/// Reads the value of the document's member "dimensions". What anchors name need not exist.
void read_value(JsonReader& reader, const JsonCursor& at, Dimensions& dimensions);
void write_value(DocumentText& text, const Dimension& dimension);

/// Reads the value of the document's member "groups". Their parents exist, ids ascend, none contains itself.
void read_value(JsonReader& reader, const JsonCursor& at, Groups& groups);
void write_value(DocumentText& text, const Group& group);

/// Reads the value of an object's member "copies". Errors: E_COPIES_INVALID.
void read_value(JsonReader& reader, const JsonCursor& at, LiveCopies& copies);
void write_value(DocumentText& text, const CopyArray& array);

void read_value(JsonReader& reader, const JsonCursor& at, Colour& colour);
void write_value(DocumentText& text, const Colour& colour);
/// Reads the value of the document's member "views".
void read_value(JsonReader& reader, const JsonCursor& at, SavedViews& views);
void write_value(DocumentText& text, const SavedView& view);

/// Unit quaternion as the row [w, x, y, z].
void read_value(JsonReader& reader, const JsonCursor& at, Eigen::Quaterniond& rotation);
void write_value(DocumentText& text, const Eigen::Quaterniond& rotation);
void read_value(JsonReader& reader, const JsonCursor& at, Similarity& transform);
void write_value(DocumentText& text, const Similarity& transform);
void read_value(JsonReader& reader, const JsonCursor& at, DisplaySettings& display);
void write_value(DocumentText& text, const DisplaySettings& display);
void read_value(JsonReader& reader, const JsonCursor& at, MakingSettings& making);
void write_value(DocumentText& text, const MakingSettings& making);

void read_value(JsonReader& reader, const JsonCursor& at, PaperModel& paper);
void write_value(DocumentText& text, const PaperModel& paper);

// Sources; "kind" is known, unknown members are kept.
std::optional<PolyhedronSource> read_polyhedron(JsonReader& reader, const JsonCursor& at);
void write_value(DocumentText& text, const PolyhedronSource& source);
std::optional<PatchSource> read_patches(JsonReader& reader, const JsonCursor& at);
void write_value(DocumentText& text, const PatchSource& source);
void read_value(JsonReader& reader, const JsonCursor& at, MeshSource& source);
void write_value(DocumentText& text, const MeshSource& source);
void read_value(JsonReader& reader, const JsonCursor& at, BezierSource& source);
void write_value(DocumentText& text, const BezierSource& source);
void read_value(JsonReader& reader, const JsonCursor& at, SolidsSource& source);
void write_value(DocumentText& text, const SolidsSource& source);
void read_value(JsonReader& reader, const JsonCursor& at, SkinSource& source);
void write_value(DocumentText& text, const SkinSource& source);
void read_value(JsonReader& reader, const JsonCursor& at, OutlineSource& source);
void write_value(DocumentText& text, const OutlineSource& source);
void read_value(JsonReader& reader, const JsonCursor& at, PictureSource& source);
void write_value(DocumentText& text, const PictureSource& source);

}  // namespace hariko::detail
