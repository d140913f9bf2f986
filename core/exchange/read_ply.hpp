#pragma once

// Stanford PLY.

#include <string_view>

#include "core/exchange/imported_mesh.hpp"

namespace hariko {

/// Polygons of a PLY file, text or binary of either byte order: element `vertex` with x, y, z of any number
/// type, and element `face` with a list `vertex_indices` or `vertex_index` of any integer types, or element
/// `tristrips` with the same, in which -1 begins a new strip; all else is skipped. Text elements stand on one
/// line each. Errors: E_PARSE, E_INDEX_RANGE, E_TRUNCATED, E_LIMIT, E_EMPTY, E_FORMAT_UNKNOWN, with a line in
/// the header and in text files, with the byte in binary ones. O(bytes), whatever the header promises.
Result<ImportedMesh> read_ply(std::string_view bytes, const ReadLimits& limits = {});

}  // namespace hariko
