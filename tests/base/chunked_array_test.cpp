#include "core/base/chunked_array.hpp"

#include <numeric>
#include <set>

#include "tests/support/random.hpp"

namespace hariko {
namespace {

using Array = ChunkedArray<int, 16>;

TEST(ChunkedArray, HoldsItsValues) {
  for (std::size_t size : {0U, 1U, 15U, 16U, 17U, 100U}) {
    std::vector<int> values(size);
    std::iota(values.begin(), values.end(), 3);
    const Array array(values);
    EXPECT_EQ(array.size(), size);
    EXPECT_EQ(array.empty(), size == 0);
    EXPECT_EQ(array.chunk_count(), (size + 15) / 16);
    EXPECT_EQ(array.to_vector(), values);
    EXPECT_EQ(Array(size, 4).to_vector(), std::vector<int>(size, 4));
  }
}

TEST(ChunkedArray, EditsLeaveOtherCopiesAlone) {
  test::for_random(701, 50, [](std::mt19937_64& rng) {
    const int size = test::uniform_int(rng, 1, 100);
    std::vector<Array> arrays{Array(static_cast<std::size_t>(size), 0)};
    std::vector<std::vector<int>> models{arrays[0].to_vector()};
    for (int step = 0; step < 100; ++step) {
      const std::size_t which = rng() % arrays.size();
      if (test::chance(rng, 0.3)) {
        arrays.push_back(Array(arrays[which]));
        models.push_back(std::vector<int>(models[which]));
      } else {
        const std::size_t i = rng() % static_cast<std::size_t>(size);
        arrays[which].edit(i) = models[which][i] = step + 1;
      }
    }
    for (std::size_t k = 0; k < arrays.size(); ++k) {
      ASSERT_EQ(arrays[k].to_vector(), models[k]);
      for (std::size_t j = 0; j < arrays.size(); ++j)
        EXPECT_EQ(arrays[k] == arrays[j], models[k] == models[j]);
    }
  });
}

TEST(ChunkedArray, AnEditCopiesOneChunk) {
  const Array first(100, 0);
  Array second = first;
  second.edit(40) = 1;
  second.edit(41) = 1;
  int different = 0;
  for (std::size_t c = 0; c < first.chunk_count(); ++c)
    different += first.chunk_address(c) != second.chunk_address(c);
  EXPECT_EQ(different, 1);
  EXPECT_FALSE(first.shares(second, 40));
  EXPECT_FALSE(first.shares(second, 32));
  EXPECT_TRUE(first.shares(second, 31));
  EXPECT_TRUE(first.shares(second, 48));
  EXPECT_FALSE(first.shares(second, 100));
}

TEST(ChunkedArray, ThousandVersionsShareMemory) {
  using Points = ChunkedArray<double, 128>;
  std::vector<Points> history{Points(20000, 0.0)};
  for (std::size_t i = 0; i < 1000; ++i) {
    history.push_back(history.back());
    history.back().edit(i * 7919 % 20000) = 1;
  }
  std::set<const void*> chunks;
  for (const Points& version : history)
    for (std::size_t c = 0; c < version.chunk_count(); ++c) chunks.insert(version.chunk_address(c));
  EXPECT_EQ(chunks.size(), history[0].chunk_count() + 1000);
}

TEST(ChunkedArrayDeathTest, OutOfRangeIsAnAssertion) {
  Array array(16, 0);
  EXPECT_DEATH(static_cast<void>(array[16]), "out of range");
  EXPECT_DEATH(static_cast<void>(array.edit(16)), "out of range");
}

}  // namespace
}  // namespace hariko
