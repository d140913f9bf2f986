#pragma once

// Local vectors of one face, edge or patch in mode FAIR's solver, and the application of elements to them.
// Internal to core/patching. Each consists of three columns, one per coordinate, one after the other.

#include <algorithm>
#include <array>

#include "core/patching/fair/element_products.hpp"
#include "core/patching/fair/fair_elements.hpp"
#include "core/patching/quartic/quartic_patch.hpp"

namespace hariko {

inline constexpr std::size_t fair_jump_size = 6, fair_control_count = quartic_control_count,
                             fair_unknown_count = patch_unknown_count;
using FairJump = std::array<double, 3 * fair_jump_size>;
using FairUnknowns = std::array<double, 3 * fair_unknown_count>;
using FairControls = std::array<double, 3 * fair_control_count>;

/// Control points of a patch as a local vector.
inline FairControls fair_controls(const QuarticPatch& patch) {
  FairControls out;
  for (std::size_t k = 0; k < fair_control_count; ++k)
    for (std::size_t c = 0; c < 3; ++c) out[c * fair_control_count + k] = patch.control[k][Eigen::Index(c)];
  return out;
}

/// Computes to = matrix from.
inline void apply_element(const Eigen::MatrixXd& matrix, const double* from, double* to) {
  const auto n = static_cast<std::size_t>(matrix.rows());
  std::fill(to, to + 3 * n, 0.0);
  add_product(n, n, matrix.data(), from, to);
}

/// Adds a patch's jump: jump += rows controls.
inline void add_jump(const JumpRows& rows, const FairControls& controls, FairJump& jump) {
  add_product(fair_jump_size, fair_control_count, rows.data(), controls.data(), jump.data());
}

/// Adds a jump's gradient: gradient += rows^T jump.
inline void add_gradient(const JumpRows& rows, const FairJump& jump, FairControls& gradient) {
  add_transposed_product(fair_control_count, fair_jump_size, rows.data(), jump.data(), gradient.data());
}

/// Adds the contribution of one patch to the face's local vector.
inline void add_to_face(const FaceElement& element, Index side, double sign, const FairUnknowns& values,
                        double* local) {
  const auto columns = element.columns(side);
  const auto size = static_cast<std::size_t>(element.matrix.rows());
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t a = 0; a < fair_unknown_count; ++a)
      local[c * size + std::size_t(columns[a])] += sign * values[c * fair_unknown_count + a];
}

}  // namespace hariko
