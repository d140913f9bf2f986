// Grids that stay while solids move.

#include "core/envelope/field_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

/// A torus about z with radius 1; its hole closes where the tube is thick.
GridRequest torus_request(double tube) {
  GridRequest out;
  const auto distance = [tube](const Vector3& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - tube;
  };
  out.field = out.sharp = {distance, [distance](const Vector3& centre, double radius, double above) {
                             const double d = distance(centre);
                             return d < -radius ? -1 : d >= radius + above ? 1 : 0;
                           }};
  out.high = {1 + tube, 1 + tube, tube};
  out.low = -out.high;
  out.thickness = 2 * tube;
  for (int i = 0; i < 24; ++i) out.covered.emplace_back(std::cos(i * 0.2618), std::sin(i * 0.2618), 0);
  return out;
}

/// Labels by spreading from node to node.
struct Flooded {
  std::vector<int> label;
  std::vector<std::size_t> sizes;
  std::vector<bool> border;

  Flooded(const FlagGrid& grid, char flag, int most_steps) : label(grid.inside.size(), -1) {
    const auto [nx, ny, nz] = grid.size();
    for (std::size_t start = 0; start < label.size(); ++start) {
      if (grid.inside[start] != flag || label[start] >= 0) continue;
      sizes.push_back(0);
      border.push_back(false);
      std::vector<std::size_t> open{start};
      label[start] = int(sizes.size()) - 1;
      while (!open.empty()) {
        const int node = int(open.back()), x = node % nx, y = node / nx % ny, z = node / nx / ny;
        open.pop_back();
        ++sizes.back();
        if (x == 0 || y == 0 || z == 0 || x == nx - 1 || y == ny - 1 || z == nz - 1) border.back() = true;
        for (int way = 0; way < 27; ++way) {
          const int dx = way % 3 - 1, dy = way / 3 % 3 - 1, dz = way / 9 - 1;
          if (std::abs(dx) + std::abs(dy) + std::abs(dz) > most_steps) continue;
          const int a = x + dx, b = y + dy, c = z + dz;
          if (a < 0 || b < 0 || c < 0 || a >= nx || b >= ny || c >= nz) continue;
          const std::size_t next = grid.index(a, b, c);
          if (grid.inside[next] != flag || label[next] >= 0) continue;
          label[next] = int(sizes.size()) - 1;
          open.push_back(next);
        }
      }
    }
  }
};

FlagGrid random_grid(std::mt19937_64& rng) {
  FlagGrid out;
  for (auto& planes : out.planes)
    for (int i = uniform_int(rng, 1, 9); i > 0; --i) planes.push_back(-i);
  const double share = uniform(rng, 0.05, 0.95);
  const auto [nx, ny, nz] = out.size();
  for (int i = 0; i < nx * ny * nz; ++i) out.inside.push_back(chance(rng, share));
  return out;
}

}  // namespace

TEST(FieldGrid, TidyingKeepsTheLargePartAndFillsVoids) {
  int dropped = 0, filled = 0;
  for_random(45, 400, [&](std::mt19937_64& rng) {
    const FlagGrid before = random_grid(rng);
    FlagGrid after = before;
    const GridTopology topology = tidy(after);
    const Flooded parts(before, 1, 1);
    std::vector<char> wanted = before.inside;
    int components = int(parts.sizes.size());
    if (components > 1) {
      const auto largest = std::ranges::max_element(parts.sizes);
      const auto total = std::count(wanted.begin(), wanted.end(), 1);
      if (double(*largest) > 0.93 * double(total)) {
        for (std::size_t i = 0; i < wanted.size(); ++i)
          wanted[i] = parts.label[i] == largest - parts.sizes.begin();
        components = 1, ++dropped;
      }
    }
    FlagGrid kept = before;
    kept.inside = wanted;
    const Flooded outside(kept, 0, 3);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (!wanted[i] && !outside.border[std::size_t(outside.label[i])]) wanted[i] = 1, ++filled;
    EXPECT_EQ(after.inside, wanted);
    EXPECT_EQ(topology.components, components);
  });
  EXPECT_GT(dropped, 0);
  EXPECT_GT(filled, 0);
}

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
  thin.field.value = [](const Vector3&) { return 1.0; };
  EXPECT_FALSE(same_grid(thin, reference, chosen->choice));
  GridRequest elsewhere = open;
  for (Vector3& p : elsewhere.covered) p.z() += 2;
  EXPECT_FALSE(same_grid(elsewhere, reference, chosen->choice));
}

}  // namespace hariko::test
