#pragma once

// Meshes as the tests of the approximation ask for them.

#include <numbers>

#include "core/approximation/approximate.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {

inline constexpr double degrees = std::numbers::pi / 180;

inline MeshApproximation mesh_of(const Surface& surface, const MeshOptions& options) {
  return must(approximate(surface, options)).value();
}

inline MeshOptions by_distance(double tolerance, SplitRule split = SplitRule::midpoint) {
  MeshOptions options;
  options.criteria.distance = tolerance;
  options.split = split;
  return options;
}

}  // namespace hariko::test
