#pragma once

// Reader of Wavefront OBJ files.

#include <string_view>

#include "core/exchange/imported_scene.hpp"

namespace hariko {

/// Semi-sharp creases or corners of the file, which become fully sharp.
inline constexpr Code w_soft_creases{"W_SOFT_CREASES"};
/// Letters of names in an old encoding, which may be the wrong ones.
inline constexpr Code w_name_letters{"W_NAME_LETTERS"};

/// Reads an OBJ file in UTF-8 or UTF-16. Polygons: `v` (colours and weights are ignored) and `f` in all its
/// forms, with negative indices and continued lines. Each `o` begins a part; without any, groups (`g`) that
/// do not touch are parts. Bezier patches (`surf`, polynomial and rational, one or several patches a surface,
/// cut to its parameter range; `bzp`) become objects of patches. Creases and corners are read from the tags
/// of OpenSubdiv's files and of `write_control_obj`. Warnings count what is left out: other free forms,
/// trimming curves, points, lines and curves, holes, other files. Texture coordinates, normals and materials
/// are ignored silently; statements unknown to OBJ give one warning together. Errors, each with its line:
/// E_PARSE, E_INDEX_RANGE, E_LIMIT, E_EMPTY, E_FORMAT_UNKNOWN (no OBJ statement at all), those of
/// `check_patch`. O(bytes).
Result<ImportedScene> read_obj_scene(std::string_view bytes, const ReadLimits& limits = {});

/// Reads the polygons as one mesh, with all vertices in their order, named after the first `o`, else the
/// first `g`. Errors: as `read_obj_scene`.
Result<ImportedMesh> read_obj(std::string_view bytes, const ReadLimits& limits = {});

}  // namespace hariko
