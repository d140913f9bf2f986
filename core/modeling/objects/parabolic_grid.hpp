#pragma once

// Bicubic control net of an arched sheet, the starting shape of a patch object.

#include "core/surface/bicubic_patch.hpp"

namespace hariko {

inline constexpr int max_net_patches = 64;  ///< patches along one side of the net

/// Control net of columns x rows bicubic patches over a rectangle (lengths `width` along x, `depth` along y)
/// centred at the origin, with normals upward. `arch` raises the middle of the width by that length along a
/// parabola; all patches together are one smooth surface. O(columns * rows).
BicubicNet parabolic_grid(Index columns, Index rows, double width, double depth, double arch);

}  // namespace hariko
