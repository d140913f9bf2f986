#pragma once

// A control net to start from.

#include "core/surface/bicubic_patch.hpp"

namespace hariko {

inline constexpr int max_net_patches = 64;  ///< along a side

/// columns x rows patches over a rectangle round zero, normals up. `arch` lifts the middle of its width by so
/// much, as a parabola; the grid is smooth throughout.
BicubicNet arched_net(Index columns, Index rows, double width, double depth, double arch);

}  // namespace hariko
