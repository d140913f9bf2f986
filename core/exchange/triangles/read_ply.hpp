#pragma once

// Reader of Stanford PLY files.

#include <string_view>

#include "core/exchange/imported_mesh.hpp"

namespace hariko {

/// Reads the polygons of a PLY file, text or binary of either byte order: element `vertex` with x, y, z of
/// any number type, and element `face` with a list `vertex_indices` or `vertex_index` of any integer types,
/// or element `tristrips` with the same, in which -1 begins a new strip. Other elements that may have a shape
/// are skipped and counted (W_LEFT_OUT), and so are faces with coordinates that are not finite; such vertices
/// are dropped. In text each row is on one line. Errors, with the line in the header and in text files, with
/// the byte in binary ones: E_PARSE, E_INDEX_RANGE, E_TRUNCATED, E_LIMIT, E_EMPTY, E_FORMAT_UNKNOWN.
/// O(bytes), whatever the header claims.
Result<ImportedMesh> read_ply(std::string_view bytes, const ReadLimits& limits = {});

}  // namespace hariko
