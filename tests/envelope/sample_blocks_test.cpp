// Blocks of samples, beside all samples one by one.

#include "core/envelope/sample_blocks.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

struct Patches {
  std::vector<std::vector<Vector3>> nodes;
  SampleBlocks blocks;
};

Vector3 random_point(std::mt19937_64& rng) {
  return {uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1)};
}

/// Bent and a little rough, of a random size and somewhere.
Patches random_patches(std::mt19937_64& rng, int side, double size, const Vector3& place) {
  const auto count = std::size_t(uniform_int(rng, 1, 5));
  Patches out{{}, SampleBlocks(side, count)};
  for (std::size_t p = 0; p < count; ++p) {
    const Vector3 origin = random_point(rng), along = random_point(rng), across = random_point(rng),
                  bend = random_point(rng);
    std::vector<Vector3>& nodes = out.nodes.emplace_back();
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double u = double(i) / (side - 1), v = double(j) / (side - 1);
        nodes.push_back(place +
                        size * (origin + u * along + v * across + u * v * bend + 0.01 * random_point(rng)));
      }
    out.blocks.add_patch(nodes);
  }
  return out;
}

}  // namespace

TEST(SampleBlocks, NumbersAreThoseOfTheNodes) {
  for_random(1, 20, [](std::mt19937_64& rng) {
    const int side = uniform_int(rng, 2, 40);
    const Patches patches = random_patches(rng, side, 1, Vector3::Zero());
    const SampleBlocks& blocks = patches.blocks;
    std::set<std::uint32_t> seen;
    for (std::uint32_t b = 0; b < blocks.block_count(); ++b)
      for (std::uint32_t k = 0; k < blocks.block_size(b); ++k)
        seen.insert(blocks.node(b * SampleBlocks::room + k));
    EXPECT_EQ(seen.size(), std::size_t(side * side));
    EXPECT_EQ(*seen.rbegin(), std::uint32_t(side * side - 1));
    for (Index p = 0; p < patches.nodes.size(); ++p)
      for (std::uint32_t b = 0; b < blocks.block_count(); ++b)
        for (std::uint32_t k = 0; k < blocks.block_size(b); ++k) {
          const std::uint32_t sample = b * SampleBlocks::room + k, node = blocks.node(sample);
          const Vector3& at = patches.nodes[p][node];
          EXPECT_EQ(blocks.position(p, sample), at);
          EXPECT_EQ(blocks.at_node(p, node), at);
          for (const Ball& ball : {blocks.ball(p), blocks.ball(p, b)})
            EXPECT_LE((at - ball.centre).norm(), ball.radius * (1 + 1e-12));
        }
  });
}

TEST(SampleBlocks, TheNearestSampleIsInABlockThatIsVisited) {
  std::size_t visited = 0, all = 0;
  for_random(1, 60, [&](std::mt19937_64& rng) {
    const int sides[] = {2, 5, 8, 15, 29, 46};
    const int side = sides[std::size_t(uniform_int(rng, 0, 5))];
    const double size = log_uniform(rng, 1e-3, 1e6);
    const Vector3 place = chance(rng, 0.5) ? Vector3::Zero() : Vector3(1e6 * random_point(rng));
    const Patches patches = random_patches(rng, side, size, place);
    for (int n = 0; n < 20; ++n) {
      const Vector3 z = place + 2 * size * random_point(rng);
      Eigen::ArrayXd bounds;
      patches.blocks.bounds_from(z, bounds);
      for (Index p = 0; p < patches.nodes.size(); ++p) {
        double least = 1e300, plain = 1e300;
        patches.blocks.visit(p, z, least, [&](std::uint32_t block) {
          const SampleBlocks::Squares squares = patches.blocks.squares_from(p, block, z);
          least = std::min(least, squares.minCoeff());
          ++visited;
        });
        all += patches.blocks.block_count();
        for (const Vector3& at : patches.nodes[p]) plain = std::min(plain, (at - z).squaredNorm());
        EXPECT_NEAR(least, plain, 1e-14 * plain);
        // The ball round the patch is as exact as its place.
        EXPECT_LE(bounds[Eigen::Index(p)], std::sqrt(plain) + 1e-12 * (size + place.norm()));
      }
    }
  });
  EXPECT_LT(2 * visited, all) << "blocks far away are to be left out";
}

TEST(SampleBlocks, NothingIsVisitedThatIsFartherThanWhatIsKnown) {
  for_random(1, 20, [](std::mt19937_64& rng) {
    const Patches patches = random_patches(rng, 15, 1, Vector3::Zero());
    const Vector3 z = Vector3(10, 0, 0) + random_point(rng);
    for (Index p = 0; p < patches.nodes.size(); ++p) {
      const double known = 1;
      patches.blocks.visit(p, z, known, [](std::uint32_t) { ADD_FAILURE(); });
    }
  });
}

}  // namespace hariko::test
