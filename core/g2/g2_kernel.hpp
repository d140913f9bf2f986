#pragma once

// The inner loop of grid evaluation of mode G2, for the processor at hand. All variants do the same additions
// and multiplications in the same order as the scalar form.

#include <span>

#include "core/g2/g2_patch_set.hpp"

namespace hariko {

struct G2Kernel {
  /// Three sums over the active controls for each point: out[3 i .. 3 i + 2].
  void (*accumulate)(const Vector3* controls, std::span<const int> active, const G2GridTable& table,
                     std::size_t points, Vector3* out);
  /// Positions and unit normals; a normal is zero where the derivatives are parallel (then returns true).
  bool (*position_normal)(const Vector3* controls, std::span<const int> active, const G2GridTable& table,
                          std::size_t points, Vector3* positions, Vector3* normals);
};

/// The fastest variant that this processor runs.
G2Kernel g2_kernel();

}  // namespace hariko
