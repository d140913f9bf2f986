#pragma once

// Bezier patches of files (read_patches.hpp) as control nets that can be edited.

#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/surface/bicubic_patch.hpp"
#include "core/surface/tensor_bezier.hpp"

namespace hariko {

/// One net a patch. E_FORMAT_UNKNOWN where a patch is not bicubic, or rational.
Result<std::vector<BicubicNet>> bicubic_nets(const std::vector<BezierPatch>& patches);

/// Errors: those of `read_bezier_text` and of `bicubic_nets`.
Result<std::vector<BicubicNet>> read_bpt(std::string_view text);

}  // namespace hariko
