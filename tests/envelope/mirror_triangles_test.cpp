#include "core/envelope/mirror_triangles.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

/// Cuts a convex polygon into triangles at random.
void cut(std::vector<Index> corners, std::mt19937_64& rng, std::vector<std::array<Index, 3>>& out) {
  while (corners.size() > 3) {
    const auto at = std::size_t(uniform_int(rng, 0, int(corners.size()) - 1));
    const std::size_t n = corners.size();
    out.push_back({corners[(at + n - 1) % n], corners[at], corners[(at + 1) % n]});
    corners.erase(corners.begin() + std::ptrdiff_t(at));
  }
  out.push_back({corners[0], corners[1], corners[2]});
}

}  // namespace

TEST(MirrorTriangles, BothEndsOfAPrismAreCutAlike) {
  for_random(4401, 200, [](std::mt19937_64& rng) {
    const auto n = Index(uniform_int(rng, 4, 12));
    std::vector<Index> top, bottom, image(2 * n);
    for (Index v = 0; v < n; ++v) {
      top.push_back(v);
      bottom.push_back(2 * n - 1 - v);
      image[v] = v + n;
      image[v + n] = v;
    }
    std::vector<std::array<Index, 3>> triangles;
    cut(top, rng, triangles);
    cut(bottom, rng, triangles);
    std::vector<std::array<Index, 3>> mantle;
    for (Index v = 0; v < n; ++v) {
      // Their own images: they cannot be cut alike on both sides, and stay.
      const Index w = (v + 1) % n;
      mantle.push_back({w, v, v + n});
      mantle.push_back({w, v + n, w + n});
    }
    triangles.insert(triangles.end(), mantle.begin(), mantle.end());
    const auto before = triangles;
    mirror_triangles(triangles, image);
    ASSERT_EQ(triangles.size(), before.size());
    std::map<std::pair<Index, Index>, int> sides;
    for (const auto& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
    for (const auto& [side, count] : sides) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(sides.contains({side.second, side.first})) << "still closed";
    }
    std::set<std::set<Index>> above, below;
    for (const auto& t : triangles) {
      if (std::max({t[0], t[1], t[2]}) < n) above.insert({t[0], t[1], t[2]});
      if (std::min({t[0], t[1], t[2]}) >= n) below.insert({t[0] - n, t[1] - n, t[2] - n});
    }
    EXPECT_EQ(above.size(), n - 2);
    EXPECT_EQ(above, below);
    EXPECT_TRUE(std::equal(mantle.begin(), mantle.end(), triangles.end() - std::ptrdiff_t(mantle.size())));
  });
}

}  // namespace hariko::test
