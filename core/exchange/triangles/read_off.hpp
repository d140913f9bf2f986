#pragma once

// Reader of Object File Format (Geomview OFF) files.

#include <string_view>

#include "core/exchange/imported_mesh.hpp"

namespace hariko {

/// Reads the polygons of an OFF file. Vertices and faces are on lines of their own, or follow each other
/// whatever the lines are; colours, normals and texture coordinates (COFF, NOFF, STOFF ...) are ignored. The
/// keyword may be in small letters, and the counts may follow it without a blank. Errors are those of a file
/// with one vertex or face a line. Homogeneous, n-dimensional and binary OFF give E_FORMAT_UNKNOWN. Other
/// errors, each with its line: E_PARSE, E_INDEX_RANGE, E_TRUNCATED, E_LIMIT, E_EMPTY. O(bytes), whatever the
/// header claims.
Result<ImportedMesh> read_off(std::string_view bytes, const ReadLimits& limits = {});

/// Whether the first word of the file is a keyword of the OFF family.
bool looks_like_off(std::string_view bytes);

}  // namespace hariko
