#pragma once

// Meshes as the tests of the approximation ask for them.

#include <gtest/gtest.h>

#include <numbers>

#include "core/approximation/approximate.hpp"

namespace hariko::test {

inline constexpr double degrees = std::numbers::pi / 180;

inline MeshApproximation mesh_of(const Surface& surface, const MeshOptions& options) {
  auto made = approximate(surface, options);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : to_string(made.error()));
  return made.ok() ? std::move(made).value() : MeshApproximation();
}

inline MeshOptions by_distance(double tolerance, SplitRule split = SplitRule::midpoint) {
  MeshOptions options;
  options.criteria.distance = tolerance;
  options.split = split;
  return options;
}

}  // namespace hariko::test
