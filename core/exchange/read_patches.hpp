#pragma once

// Readers of files with tensor Bezier patches of any degree.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/exchange/named_patches.hpp"
#include "core/surface/tensor_bezier.hpp"

namespace hariko {

/// Text of either kind. The plain one: the number of patches; for each its degrees m n, then (m + 1)(n + 1)
/// points, row by row. The indexed one: the number of bicubic patches; for each 16 numbers of points, from 1,
/// with commas between; the number of points; each as x,y,z. Errors: E_EMPTY, E_PARSE, E_TRUNCATED, E_LIMIT,
/// E_INDEX_RANGE, all with the line, and those of `check_patch`.
Result<std::vector<BezierPatch>> read_bezier_text(std::string_view text);

/// {"name": [{"ctrl": [[[x, y, z], ..], ..], "weights": [[..], ..]}, ..], ..}; ctrl[i][j] with i along s.
/// Weights and further members may be missing. Errors: E_EMPTY, E_PARSE, E_LIMIT, those of `check_patch`.
Result<std::vector<NamedPatches>> read_bezier_json(std::string_view text);

/// JSON by the ending .json, else text. Errors: those of `read_file` and of the readers above.
Result<std::vector<NamedPatches>> read_patch_file(const std::filesystem::path& path);

}  // namespace hariko
