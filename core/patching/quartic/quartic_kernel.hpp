#pragma once

// Inner loop of grid evaluation, by kind of processor. All variants do the same additions and multiplications
// in the same order: results do not depend on the processor.

#include <span>

#include "core/patching/quartic/quartic_patch.hpp"

namespace hariko {

/// Functions of one variant of the kernel; all write `points` results.
struct QuarticKernel {
  /// Positions and unit normals; a normal is zero where the derivatives are parallel (then returns true).
  bool (*position_normal)(const QuarticPatch& patch, const QuarticGridTable& table, std::size_t points,
                          Vector3* positions, Vector3* normals);
  /// Points with first derivatives; second derivatives are set to zero.
  void (*first_order)(const QuarticPatch& patch, const QuarticGridTable& table, std::size_t points,
                      PatchPoint* out);
  void (*second_order)(const QuarticPatch& patch, const QuarticGridTable& table, std::size_t points,
                       PatchPoint* out);
};

/// Table of the basis functions at any points (its pattern is meaningless).
QuarticGridTable quartic_point_table(std::span<const Vector2> parameters);

/// Fastest variant that this processor supports.
QuarticKernel quartic_kernel();

}  // namespace hariko
