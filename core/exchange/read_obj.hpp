#pragma once

// Wavefront OBJ.

#include <string_view>

#include "core/exchange/imported_mesh.hpp"

namespace hariko {

/// Polygons of an OBJ file: `v` (colours and weights are ignored) and `f` in all its forms, with negative
/// indices and continued lines. All objects and groups become one mesh, named after the first `o`, else the
/// first `g`. Texture coordinates, normals, materials, lines and curves are ignored silently; statements that
/// OBJ does not know give one warning together. Errors, each with its line: E_PARSE, E_INDEX_RANGE, E_LIMIT,
/// E_EMPTY, E_FORMAT_UNKNOWN (no OBJ statement at all). O(bytes).
Result<ImportedMesh> read_obj(std::string_view bytes, const ReadLimits& limits = {});

}  // namespace hariko
