#pragma once

// NamedPatches: loose Bezier patches of a file that are one object.

#include <string>
#include <vector>

#include "core/surface/bezier_patch.hpp"

namespace hariko {

/// Patches that belong together, loose: `weld_patches` joins them. Points are absolute.
struct NamedPatches {
  std::string name;  ///< printable; empty when the file gives none
  std::vector<BezierPatch> patches;
};

inline constexpr std::size_t max_patches_of_file = 100'000;

}  // namespace hariko
