#pragma once

// NamedPatches: Bezier patches of a file that form one object.

#include <string>
#include <vector>

#include "core/surface/bezier_patch.hpp"

namespace hariko {

/// Bezier patches of one object, not joined yet: `weld_patches` joins them. Points are absolute.
struct NamedPatches {
  std::string name;  ///< printable; empty where the file gives none
  std::vector<BezierPatch> patches;
};

/// Limit of the patches of a file.
inline constexpr std::size_t max_patches_of_file = 100'000;

}  // namespace hariko
