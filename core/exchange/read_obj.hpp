#pragma once

// Wavefront OBJ.

#include <string_view>

#include "core/exchange/imported_scene.hpp"

namespace hariko {

/// Creases or corners are sharper here than in the file, which knows degrees of sharpness.
inline constexpr Code w_soft_creases{"W_SOFT_CREASES"};

/// An OBJ file in UTF-8 or UTF-16. Polygons: `v` (colours and weights are ignored) and `f` in all its forms,
/// with negative indices and continued lines. Each `o` begins a part; where there is none, groups (`g`) that
/// meet in no place are parts. Bezier patches (`surf`, polynomial and rational, one patch or several a
/// surface) become objects of patches; other free forms are left out with a warning. Creases and corners are
/// the tags that OpenSubdiv's files and `write_control_obj` have. Texture coordinates, normals, materials,
/// lines and curves are ignored silently; statements that OBJ does not know give one warning together.
/// Errors, each with its line: E_PARSE, E_INDEX_RANGE, E_LIMIT, E_EMPTY, E_FORMAT_UNKNOWN (no OBJ statement
/// at all), those of `check_patch`. O(bytes).
Result<ImportedScene> read_obj_scene(std::string_view bytes, const ReadLimits& limits = {});

/// The polygons as one mesh, all vertices in their order, named after the first `o`, else the first `g`.
Result<ImportedMesh> read_obj(std::string_view bytes, const ReadLimits& limits = {});

}  // namespace hariko
