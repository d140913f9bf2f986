#pragma once

// Reader of STL files.

#include <string_view>

#include "core/exchange/imported_scene.hpp"

namespace hariko {

/// Reads the triangles of an STL file, text or binary (also binary that starts with "solid": the file's size
/// tells). Each solid with triangles is a part with its name; more than `ImportedScene::max_parts` become one
/// (W_OBJECTS_JOINED). Corners of a solid at exactly equal positions become one vertex; to join by distance
/// use `weld` (repair.hpp) afterwards. Stored normals and attributes are ignored; triangles with two equal
/// positions are dropped with one warning, and so are those with coordinates that are not finite
/// (W_LEFT_OUT). In text, blanks and line ends are alike except behind a name. Binary files whose count is 0
/// or has all bits set are read to their end (W_COUNT_MISSING); text may lack its last "endsolid"
/// (W_END_MISSING). Errors, with a line in text files and the triangle in binary ones: E_PARSE, E_TRUNCATED,
/// E_LIMIT, E_EMPTY; E_FORMAT_UNKNOWN for other text. Expected time O(bytes).
Result<ImportedScene> read_stl_scene(std::string_view bytes, const ReadLimits& limits = {});

/// The same as one mesh, named after the first solid.
Result<ImportedMesh> read_stl(std::string_view bytes, const ReadLimits& limits = {});

/// Whether the bytes are text that starts with "solid", or have exactly the size that a binary header gives.
bool looks_like_stl(std::string_view bytes);

}  // namespace hariko
