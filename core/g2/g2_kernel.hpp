#pragma once

// Inner loop of grid evaluation in mode G2, by kind of processor. All variants do the same additions and
// multiplications in the same order as the scalar form.

#include <span>

#include "core/g2/g2_patch_set.hpp"

namespace hariko {

/// Functions of one variant of the kernel.
struct G2Kernel {
  /// Computes three sums over the active controls for each point: out[3 i .. 3 i + 2].
  void (*accumulate)(const Vector3* controls, std::span<const int> active, const G2GridTable& table,
                     std::size_t points, Vector3* out);
  /// Computes positions and unit normals; a normal is zero where the derivatives are parallel (then returns
  /// true).
  bool (*position_normal)(const Vector3* controls, std::span<const int> active, const G2GridTable& table,
                          std::size_t points, Vector3* positions, Vector3* normals);
};

/// Fastest variant that this processor supports.
G2Kernel g2_kernel();

}  // namespace hariko
