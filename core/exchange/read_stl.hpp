#pragma once

// STL.

#include <string_view>

#include "core/exchange/imported_mesh.hpp"

namespace hariko {

/// Triangles of an STL file, text or binary (also binary that starts with "solid": its size tells). Corners
/// at exactly equal positions become one vertex; for a distance use `weld` (repair.hpp) afterwards. Stored
/// normals and attributes are ignored; triangles that name one position twice are dropped with one warning.
/// Several solids become one mesh, named after the first. Binary files whose count is 0 or all bits are read
/// as far as they go (W_COUNT_MISSING), text may lack its last "endsolid" (W_END_MISSING). Errors: E_PARSE,
/// E_TRUNCATED, E_LIMIT, E_EMPTY, with a line in text files and the triangle in binary ones. Expected time
/// O(bytes).
Result<ImportedMesh> read_stl(std::string_view bytes, const ReadLimits& limits = {});

/// True for text that starts with "solid", and for bytes of exactly the size that a binary header promises.
bool looks_like_stl(std::string_view bytes);

}  // namespace hariko
