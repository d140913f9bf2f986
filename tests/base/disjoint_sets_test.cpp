#include "core/base/disjoint_sets.hpp"

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// Against classes that are relabelled in full at every join.
TEST(DisjointSets, TheLeastItemOfASetStandsForIt) {
  for_random(11, 50, [](std::mt19937_64& rng) {
    const int count = uniform_int(rng, 1, 60);
    DisjointSets sets(std::size_t(count) / 2);
    while (sets.size() < std::size_t(count)) {
      const Index added = sets.add();
      ASSERT_EQ(added + 1, sets.size());
      ASSERT_EQ(sets.find(added), added);
    }
    std::vector<Index> label(std::size_t(count), 0);
    std::iota(label.begin(), label.end(), Index{0});
    for (int join = uniform_int(rng, 0, count); join > 0; --join) {
      const auto a = Index(uniform_int(rng, 0, count - 1)), b = Index(uniform_int(rng, 0, count - 1));
      sets.join(a, b);
      const Index low = std::min(label[a], label[b]), high = std::max(label[a], label[b]);
      std::replace(label.begin(), label.end(), high, low);
    }
    for (Index i = 0; i < label.size(); ++i) EXPECT_EQ(sets.find(i), label[i]);
  });
}

}  // namespace
}  // namespace hariko::test
