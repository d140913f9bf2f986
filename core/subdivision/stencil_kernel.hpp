#pragma once

// Inner loop of the grid evaluation of subdivision surfaces, in variants for different processors. All
// variants do the same additions and multiplications in the same order as the scalar form.

#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Weights of a patch's controls at the points of a grid, in the layout of grid_kernel: for each block of
/// four points and each control three groups (value, d/ds, d/dt, or the second derivatives) of four doubles.
struct StencilTable {
  std::size_t blocks = 0, controls = 0;
  std::vector<double> value;
};

/// Functions of one variant of the kernel.
struct StencilKernel {
  /// Computes three sums over the controls for each point: out[3 i .. 3 i + 2].
  void (*accumulate)(std::span<const Vector3> controls, const StencilTable& table, std::size_t points,
                     Vector3* out);
  /// Computes positions and unit normals; a normal is zero where the derivatives are parallel (then returns
  /// true).
  bool (*position_normal)(std::span<const Vector3> controls, const StencilTable& table, std::size_t points,
                          Vector3* positions, Vector3* normals);
};

/// Fastest variant that this processor supports.
StencilKernel stencil_kernel();

/// Value at one point of a table, bit-identical to the kernel's.
Vector3 table_value(std::span<const Vector3> controls, const StencilTable& table, std::size_t point);

}  // namespace hariko
