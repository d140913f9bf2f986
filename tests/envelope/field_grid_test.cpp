// Grids that stay while solids move.

#include "core/envelope/field_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hariko::test {

namespace {

/// A torus about z with radius 1; its hole closes where the tube is thick.
GridRequest torus_request(double tube) {
  GridRequest out;
  out.field =
      out.sharp = [tube](const Vector3& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - tube; };
  out.high = {1 + tube, 1 + tube, tube};
  out.low = -out.high;
  out.thickness = 2 * tube;
  for (int i = 0; i < 24; ++i) out.covered.emplace_back(std::cos(i * 0.2618), std::sin(i * 0.2618), 0);
  return out;
}

}  // namespace

TEST(FieldGrid, TheSameSolidsHaveTheSameGrid) {
  for (const double tube : {0.2, 0.35, 0.5}) {
    SCOPED_TRACE(tube);
    const GridRequest request = torus_request(tube);
    const GridReference reference = grid_reference(request);
    const auto chosen = choose_grid(request, reference);
    ASSERT_TRUE(chosen);
    ASSERT_EQ(chosen->topology, (GridTopology{1, 1}));
    const auto same = same_grid(request, reference, chosen->choice);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->topology, chosen->topology);
    EXPECT_EQ(sign_changes(same->grid), sign_changes(chosen->grid));
    // Planes farther out may differ: nothing is there.
    EXPECT_EQ(std::ranges::count(same->grid.inside, 1), std::ranges::count(chosen->grid.inside, 1));
  }
}

TEST(FieldGrid, AGridIsGivenUpWhereItsTopologyOrItsPointsAreLost) {
  const GridRequest open = torus_request(0.3);
  const GridReference reference = grid_reference(open);
  const auto chosen = choose_grid(open, reference);
  ASSERT_TRUE(chosen);
  EXPECT_TRUE(same_grid(torus_request(0.32), grid_reference(torus_request(0.32)), chosen->choice));
  // The hole has closed, but the reference still has it.
  EXPECT_FALSE(same_grid(torus_request(0.95), reference, chosen->choice));
  GridRequest thin = open;
  thin.field = [](const Vector3&) { return 1.0; };
  EXPECT_FALSE(same_grid(thin, reference, chosen->choice));
  GridRequest elsewhere = open;
  for (Vector3& p : elsewhere.covered) p.z() += 2;
  EXPECT_FALSE(same_grid(elsewhere, reference, chosen->choice));
}

}  // namespace hariko::test
