#pragma once

// The file format *.hariko: a document as JSON text and back. docs/format.md describes it.

#include <string>
#include <string_view>

#include "core/base/files/file_io.hpp"
#include "core/document/document.hpp"

namespace hariko {

inline constexpr Code e_schema{"E_SCHEMA"};
inline constexpr Code e_format{"E_FORMAT"};
inline constexpr Code e_version_newer{"E_VERSION_NEWER"};

/// Version that `write_document` writes, and the highest that `read_document` reads.
inline constexpr int format_version = 10;

/// Limits on input, so that no file can exhaust memory or time.
inline constexpr std::size_t max_document_bytes = std::size_t(256) << 20;
/// Numbers, strings, arrays, objects together.
inline constexpr std::size_t max_document_values = 20'000'000;
inline constexpr int max_document_depth = 64;

/// Reads a document. Errors: E_LIMIT (text too long, or too many or too deeply nested values); E_PARSE (not
/// JSON; the element is the line, the text gives line and column); E_FORMAT (JSON, but not a Hariko
/// document); E_VERSION_NEWER; E_SCHEMA (a member is missing or has a wrong type, size or range; the text
/// names it by its path, such as objects[2].source.vertices[17]); where polygons make no polyhedron, the code
/// of `Polyhedron::build` with the element's stable id; E_NAME_EMPTY and the tension codes where a value
/// itself is refused. O(text).
Result<Document> read_document(std::string_view text);

/// Text of a document, UTF-8 with line feeds, independent of the locale. `read_document` returns an equal
/// document, and writing that gives the same text.
std::string write_document(const Document& document);

}  // namespace hariko
