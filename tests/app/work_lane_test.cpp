#include "app/engines/work_lane.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <random>
#include <vector>

namespace hariko {
namespace {

using namespace std::chrono_literals;

/// A job that runs until it is let go, and then publishes its number.
struct Gate {
  std::promise<void> open;
  std::shared_future<void> opened{open.get_future().share()};
  std::promise<void> start;
  std::future<void> started{start.get_future()};
};

WorkLane::Job gated(const std::shared_ptr<Gate>& gate, std::vector<int>& published, int number) {
  return [gate, &published, number](const CancelToken& cancel) -> WorkLane::Publication {
    gate->start.set_value();
    while (!cancel.cancelled() && gate->opened.wait_for(1ms) != std::future_status::ready) {
    }
    return [&published, number] { published.push_back(number); };
  };
}

WorkLane::Job quick(std::vector<int>& published, int number, std::atomic<int>* runs = nullptr) {
  return [&published, number, runs](const CancelToken&) -> WorkLane::Publication {
    if (runs) ++*runs;
    return [&published, number] { published.push_back(number); };
  };
}

TEST(WorkLane, LatestWaitingJobOfAKeyWins) {
  std::vector<int> published;
  std::atomic<int> runs = 0;
  auto gate = std::make_shared<Gate>();
  WorkLane lane;
  lane.submit(1, gated(gate, published, 0), WorkLane::Running::finish);
  gate->started.wait();
  for (int i = 1; i <= 5; ++i) lane.submit(1, quick(published, i, &runs), WorkLane::Running::finish);
  EXPECT_TRUE(lane.busy(1));
  EXPECT_FALSE(lane.busy(2));
  gate->open.set_value();
  lane.wait();
  EXPECT_TRUE(published.empty()) << "nothing is published before the main thread asks";
  EXPECT_EQ(lane.publish(), 2U);
  EXPECT_EQ(published, (std::vector<int>{0, 5}));
  EXPECT_EQ(runs, 1) << "jobs 1 to 4 must never run";
  EXPECT_TRUE(lane.idle());
}

TEST(WorkLane, NewJobCancelsTheRunningOneWhenAsked) {
  std::vector<int> published;
  auto gate = std::make_shared<Gate>();  // never opened: only cancellation ends the job
  WorkLane lane;
  lane.submit(1, gated(gate, published, 0), WorkLane::Running::finish);
  gate->started.wait();
  const auto begin = std::chrono::steady_clock::now();
  lane.submit(1, quick(published, 1), WorkLane::Running::cancel);
  lane.wait();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
  lane.publish();
  EXPECT_EQ(published, std::vector<int>{1});
}

TEST(WorkLane, FinishedButUnpublishedResultIsDroppedByCancellation) {
  std::vector<int> published;
  WorkLane lane;
  lane.submit(1, quick(published, 1), WorkLane::Running::finish);
  lane.submit(2, quick(published, 2), WorkLane::Running::finish);
  lane.wait();
  lane.cancel(1);
  EXPECT_FALSE(lane.busy(1));
  EXPECT_TRUE(lane.busy(2));
  lane.publish();
  EXPECT_EQ(published, std::vector<int>{2});
  lane.submit(2, quick(published, 3), WorkLane::Running::finish);
  lane.wait();
  lane.submit(2, quick(published, 4), WorkLane::Running::cancel);
  lane.wait();
  lane.publish();
  EXPECT_EQ(published, (std::vector<int>{2, 4}));
}

TEST(WorkLane, PublicationMayCancelAndSubmit) {
  std::vector<int> published;
  WorkLane lane;
  lane.submit(
      1,
      [&](const CancelToken&) -> WorkLane::Publication {
        return [&] {
          published.push_back(1);
          lane.cancel(2);
          lane.submit(3, quick(published, 3), WorkLane::Running::finish);
        };
      },
      WorkLane::Running::finish);
  lane.submit(2, quick(published, 2), WorkLane::Running::finish);
  lane.wait();
  lane.publish();
  lane.wait();
  lane.publish();
  EXPECT_EQ(published, (std::vector<int>{1, 3}));
}

TEST(WorkLane, KeysTakeTurns) {
  std::vector<int> published;
  auto gate = std::make_shared<Gate>();
  WorkLane lane;
  lane.submit(1, gated(gate, published, 0), WorkLane::Running::finish);
  gate->started.wait();
  lane.submit(1, quick(published, 10), WorkLane::Running::finish);
  lane.submit(2, quick(published, 20), WorkLane::Running::finish);
  lane.submit(1, quick(published, 11), WorkLane::Running::finish);
  gate->open.set_value();
  lane.wait();
  lane.publish();
  EXPECT_EQ(published, (std::vector<int>{0, 11, 20}));
}

TEST(WorkLane, WakesOncePerResultAndWhenTheLastJobWasCancelled) {
  std::vector<int> published;
  std::atomic<int> woken = 0;
  auto gate = std::make_shared<Gate>();
  {
    WorkLane lane([&] { ++woken; });
    lane.submit(1, quick(published, 1), WorkLane::Running::finish);
    lane.wait();
    lane.submit(2, gated(gate, published, 2), WorkLane::Running::finish);
    gate->started.wait();
    lane.submit(3, quick(published, 3), WorkLane::Running::finish);
    lane.cancel(2);  // another comes: no reason to wake for this one
    lane.wait();
    auto last = std::make_shared<Gate>();
    lane.submit(4, gated(last, published, 4), WorkLane::Running::finish);
    last->started.wait();
    lane.cancel(4);
    lane.wait();
    lane.publish();
  }
  EXPECT_EQ(woken, 3);
  EXPECT_EQ(published, (std::vector<int>{1, 3}));
}

TEST(WorkLane, DestructionCancelsARunningJob) {
  std::vector<int> published;
  auto gate = std::make_shared<Gate>();
  const auto begin = std::chrono::steady_clock::now();
  {
    WorkLane lane;
    lane.submit(1, gated(gate, published, 1), WorkLane::Running::finish);
    gate->started.wait();
    lane.submit(1, quick(published, 2), WorkLane::Running::finish);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
  EXPECT_TRUE(published.empty());
}

/// Many random submissions: of every key, results come in the order of submission, and the last one always
/// comes unless it was cancelled.
TEST(WorkLane, RandomSubmissionsNeverPublishStaleResults) {
  const char* given = std::getenv("HARIKO_SEED");
  const std::uint64_t seed = given ? std::strtoull(given, nullptr, 10) : 20261;
  SCOPED_TRACE("HARIKO_SEED=" + std::to_string(seed));
  std::mt19937_64 random(seed);
  constexpr int keys = 4;
  std::vector<int> last_published(keys, -1), last_submitted(keys, -1);
  bool ordered = true;
  WorkLane lane;
  for (int i = 0; i < 3000; ++i) {
    const auto key = static_cast<std::size_t>(random() % keys);
    const auto what = random() % 10;
    if (what == 0) {
      lane.cancel(key);
      last_submitted[key] = last_published[key];
    } else {
      const auto spin = random() % 2000;
      lane.submit(
          key,
          [&, key, i, spin](const CancelToken& cancel) -> WorkLane::Publication {
            for (std::uint64_t k = 0; k < spin && !cancel.cancelled(); ++k) {
              volatile int work = 0;
              work = work + 1;
            }
            return [&, key, i] {
              ordered = ordered && i > last_published[key];
              last_published[key] = i;
            };
          },
          what < 5 ? WorkLane::Running::cancel : WorkLane::Running::finish);
      last_submitted[key] = i;
    }
    if (random() % 3 == 0) lane.publish();
  }
  lane.wait();
  lane.publish();
  EXPECT_TRUE(ordered);
  EXPECT_EQ(last_published, last_submitted);
}

}  // namespace
}  // namespace hariko
