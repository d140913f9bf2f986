#pragma once

// Readers of files with tensor-product Bezier patches of any degree.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/exchange/named_patches.hpp"
#include "core/surface/tensor_bezier.hpp"

namespace hariko {

/// Reads Bezier patches from text in one of two forms. Plain: the number of patches; for each its degrees m
/// n, then (m + 1)(n + 1) points, row by row. Indexed: the number of bicubic patches; for each 16 point
/// numbers, from 1, separated by commas; the number of points; each point as x,y,z. Errors, with the line:
/// E_EMPTY, E_PARSE, E_TRUNCATED, E_LIMIT, E_INDEX_RANGE, and those of `check_patch`. O(size).
Result<std::vector<BezierPatch>> read_bezier_text(std::string_view text);

/// Reads Bezier patches from JSON: {"name": [{"ctrl": [[[x, y, z], ..], ..], "weights": [[..], ..]}, ..],
/// ..}; ctrl[i][j] with i along s. Weights may be missing; further members are ignored. Errors: E_EMPTY,
/// E_PARSE, E_LIMIT, those of `check_patch`. O(size).
Result<std::vector<NamedPatches>> read_bezier_json(std::string_view text);

/// Reads a patch file: JSON where its ending is .json, else text. Errors: those of `read_file` and of the
/// readers above.
Result<std::vector<NamedPatches>> read_patch_file(const std::filesystem::path& path);

}  // namespace hariko
