// The order in which facets are cut.

#include "core/approximation/refinement/facet_queue.hpp"

#include <limits>
#include <map>
#include <set>

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

std::uint64_t same_place(Index) {
  return 0;
}

/// Pushes `count` entries and pops them all, pushing a smaller error for some of those that are popped, as
/// cuts do. `check` gets each popped error and the largest that was left with it.
template <class Check>
void run(std::mt19937_64& rng, std::size_t count, const Check& check) {
  FacetQueue queue(&same_place);
  std::multiset<double> left;
  std::map<Index, int> times;
  Index next = 0;
  const auto push = [&](double error) {
    queue.push({error, next, 0});
    left.insert(error);
    times[next++] = 0;
  };
  for (std::size_t k = 0; k < count; ++k) push(std::exp(uniform(rng, 0, 9)));
  while (!queue.empty()) {
    ASSERT_EQ(queue.size(), left.size());
    const FacetQueue::Entry entry = queue.pop();
    check(entry.error, *left.rbegin());
    left.erase(left.find(entry.error));
    EXPECT_EQ(++times[entry.facet], 1);
    if (entry.error > 2 && chance(rng, 0.3)) push(0.5 * entry.error);
  }
  EXPECT_TRUE(left.empty());
  for (const auto& [facet, popped] : times) EXPECT_EQ(popped, 1);
}

TEST(FacetQueue, AFewComeByTheirErrors) {
  for_random(4711, 3, [](std::mt19937_64& rng) {
    run(rng, 2000, [](double error, double largest) { EXPECT_EQ(error, largest); });
  });
}

TEST(FacetQueue, AmongManyAFactorOfTwoDoesNotCount) {
  for_random(4712, 1, [](std::mt19937_64& rng) {
    run(rng, 30'000, [](double error, double largest) { EXPECT_GE(error, 0.5 * largest); });
  });
}

TEST(FacetQueue, EqualErrorsComeByTheirNumbersAndEndlessOnesFirst) {
  FacetQueue queue(&same_place);
  for (const Index facet : {7U, 3U, 5U}) queue.push({2.0, facet, 0});
  queue.push({std::numeric_limits<double>::infinity(), 9, 0});
  for (const Index facet : {9U, 3U, 5U, 7U}) EXPECT_EQ(queue.pop().facet, facet);
}

}  // namespace
}  // namespace hariko::test
