#include "core/base/parallel.hpp"

#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "tests/support/random.hpp"

namespace hariko {
namespace {

TEST(ParallelFor, CoversEveryItemOnce) {
  for (int threads : {1, 2}) {
    const ParallelLimit limit(threads);
    for (std::size_t count : {0U, 1U, 99U, 100U, 101U, 12345U}) {
      std::vector<int> visits(count, 0);
      parallel_for(count, 100, [&](std::size_t begin, std::size_t end) {
        EXPECT_LE(end - begin, 100U);
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
  }
}

TEST(ParallelFor, RangesDoNotDependOnTheNumberOfThreads) {
  const auto ranges = [](int threads) {
    const ParallelLimit limit(threads);
    std::mutex mutex;
    std::set<std::pair<std::size_t, std::size_t>> out;
    parallel_for(1005, 10, [&](std::size_t begin, std::size_t end) {
      const std::scoped_lock lock(mutex);
      out.insert({begin, end});
    });
    return out;
  };
  EXPECT_EQ(ranges(1), ranges(2));
  EXPECT_EQ(ranges(1).size(), 101U);
}

TEST(ParallelFor, OneGrainRunsOnTheCallingThread) {
  std::thread::id worker;
  parallel_for(10, 10, [&](std::size_t, std::size_t) { worker = std::this_thread::get_id(); });
  EXPECT_EQ(worker, std::this_thread::get_id());
}

TEST(ParallelFor, NestsAndStaysSerialUnderALimitOfOne) {
  const ParallelLimit limit(1);
  std::atomic<int> items = 0;
  std::set<std::thread::id> threads;
  parallel_for(8, 1, [&](std::size_t, std::size_t) {
    threads.insert(std::this_thread::get_id());
    parallel_for(100, 10,
                 [&](std::size_t begin, std::size_t end) { items += static_cast<int>(end - begin); });
  });
  EXPECT_EQ(items, 800);
  EXPECT_EQ(threads.size(), 1U);
}

TEST(ParallelSum, IsBitIdenticalOnAnyNumberOfThreads) {
  test::for_random(801, 20, [](std::mt19937_64& rng) {
    std::vector<double> values(static_cast<std::size_t>(test::uniform_int(rng, 1, 200000)));
    for (double& v : values) v = test::random_vector(rng).x() * test::log_uniform(rng, 1e-12, 1e12);
    const auto body = [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i) sum += values[i];
      return sum;
    };
    const auto sum = [&](int threads) {
      const ParallelLimit limit(threads);
      return parallel_sum(values.size(), 1000, body);
    };
    const double serial = sum(1);
    for (int repeat = 0; repeat < 5; ++repeat) EXPECT_EQ(sum(2), serial);
    // The order of the sum is that of the ranges.
    double by_hand = 0;
    for (std::size_t begin = 0; begin < values.size(); begin += 1000)
      by_hand += body(begin, std::min(values.size(), begin + 1000));
    EXPECT_EQ(serial, by_hand);
  });
}

TEST(ParallelSum, OfNothingIsZero) {
  EXPECT_EQ(parallel_sum(0, 10, [](std::size_t, std::size_t) { return 1.0; }), 0.0);
}

}  // namespace
}  // namespace hariko
