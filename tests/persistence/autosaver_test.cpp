// The autosaver on a virtual clock: what is on the disk is never older than promised, whatever is edited
// when.

#include "app/persistence/autosaver.hpp"

#include <thread>

#include "tests/persistence/numbers.hpp"
#include "tests/support/failing_layer.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

Document numbered(std::uint64_t number) {
  static const Document base = document_from_mesh(test::cube(), "0").value();
  Document document = base;
  Object object = *document.objects[0];
  object.name = std::to_string(number);
  document.objects[0] = std::make_shared<const Object>(std::move(object));
  return document;
}

Autosaver::Work work(std::uint64_t serial, std::uint64_t epoch = 1) {
  return {numbered(serial), {epoch, serial}, {"/model.hariko", {}, 0}};
}

/// The copies of sessions that ended, newest first.
std::vector<std::uint64_t> recovered(const fs::path& folder) {
  std::vector<std::uint64_t> numbers;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory())
      if (const auto copy = read_recovery(entry.path())) numbers.push_back(test::number_of(copy->document));
  return numbers;
}

TEST(Autosaver, NeverFallsBehindByMoreThanTheInterval) {
  test::for_random(31, 30, [](std::mt19937_64& rng) {
    const test::TemporaryFolder folder;
    Autosaver saver{RecoveryStore(folder.path())};
    const double interval = test::uniform(rng, 1, 30), frame = test::uniform(rng, 0.1, 1);
    double now = test::uniform(rng, 0, 1e5);
    std::vector<double> committed_at{now};  // by serial
    int writes = 0;
    for (int step = 0; step < 300; ++step) {
      now += frame;
      // Now busy, now at rest.
      if (test::chance(rng, (step / 50) % 2 == 0 ? 0.5 : 0.02)) {
        committed_at.push_back(now);
        saver.set_work(work(committed_at.size() - 1));
      }
      if (saver.due(now, interval)) {
        saver.started(now);
        ASSERT_TRUE(saver.write(0));
        ++writes;
      }
      // Killed here: everything that was committed an interval and a frame ago is on the disk.
      if (committed_at.size() == 1) continue;
      const auto found = recovered(folder.path());
      ASSERT_EQ(found.size(), 1U);
      if (found[0] + 1 < committed_at.size()) {
        ASSERT_LE(now - committed_at[found[0] + 1], interval + frame);
      }
    }
    ASSERT_LE(writes, 300 * frame / interval + 2) << "and it does not write all the time";
  });
}

TEST(Autosaver, AFirstChangeAfterARestIsWrittenAtOnce) {
  const test::TemporaryFolder folder;
  Autosaver saver{RecoveryStore(folder.path())};
  EXPECT_FALSE(saver.due(0, 20));
  EXPECT_LT(saver.due_in(0, 20), 0);
  saver.set_work(work(1));
  EXPECT_TRUE(saver.due(0, 20));
  saver.started(0);
  ASSERT_TRUE(saver.write(0));
  EXPECT_LT(saver.due_in(1, 20), 0) << "nothing changed";
  saver.set_work(work(2));
  EXPECT_DOUBLE_EQ(saver.due_in(1, 20), 19);
  EXPECT_TRUE(saver.due(20, 20));
}

TEST(Autosaver, WhatIsSavedOrDiscardedLeavesNoCopy) {
  const test::TemporaryFolder folder;
  Autosaver saver{RecoveryStore(folder.path())};
  saver.set_work(work(1));
  ASSERT_TRUE(saver.write(0));
  EXPECT_EQ(recovered(folder.path()), std::vector<std::uint64_t>{1});
  saver.set_nothing();
  EXPECT_TRUE(saver.due(0.001, 20)) << "at once";
  ASSERT_TRUE(saver.write(0));
  EXPECT_TRUE(saver.up_to_date());
  EXPECT_TRUE(recovered(folder.path()).empty());
  // Undo to an older state with the same serial in another document is another state.
  saver.set_work(work(1, 2));
  EXPECT_FALSE(saver.up_to_date());
  ASSERT_TRUE(saver.write(0));
  EXPECT_EQ(recovered(folder.path()), std::vector<std::uint64_t>{1});
}

TEST(Autosaver, RecoveredWorkStaysUntilItIsSaved) {
  const test::TemporaryFolder folder;
  const RecoveryStore store(folder.path());
  {
    Autosaver crashed{store};
    crashed.set_work(work(7));
    ASSERT_TRUE(crashed.write(0));
  }
  Autosaver saver{store};
  saver.set_work(work(3, 1));
  ASSERT_TRUE(saver.write(0));
  const auto found = store.leftovers(0);
  ASSERT_EQ(found.size(), 1U);
  saver.adopt(store.adopt(found[0].id, 0).value(), work(0, 2));
  EXPECT_TRUE(saver.up_to_date());
  EXPECT_EQ(recovered(folder.path()), std::vector<std::uint64_t>{7})
      << "the copy of the document before it is gone";
  saver.set_work(work(9, 2));
  ASSERT_TRUE(saver.write(0));
  EXPECT_EQ(recovered(folder.path()), std::vector<std::uint64_t>{9}) << "in the same place";
  saver.set_nothing();
  ASSERT_TRUE(saver.write(0));
  EXPECT_TRUE(recovered(folder.path()).empty());
}

TEST(Autosaver, AFailureIsSaidAndTriedAgain) {
  for (int failing = 0; failing < 12; ++failing) {
    const test::TemporaryFolder folder;
    Autosaver saver(RecoveryStore(folder.path()),
                    std::make_shared<test::FailingLayer>(failing, ENOSPC, false, 1 << 20));
    saver.set_work(work(1));
    saver.started(0);
    const bool ok = saver.write(0).ok();
    EXPECT_EQ(saver.up_to_date(), ok);
    if (!ok) {
      EXPECT_DOUBLE_EQ(saver.due_in(5, 20), 15);
      ASSERT_TRUE(saver.write(0));
    }
    EXPECT_EQ(recovered(folder.path()), std::vector<std::uint64_t>{1});
  }
}

TEST(Autosaver, CanBeWrittenFromAnotherThreadWhileWorkChanges) {
  const test::TemporaryFolder folder;
  Autosaver saver{RecoveryStore(folder.path())};
  constexpr std::uint64_t last = 200;
  std::thread writer([&] {
    while (!(saver.is_latest({1, last}) && saver.up_to_date())) (void)saver.write(0);
  });
  for (std::uint64_t i = 1; i <= last; ++i) saver.set_work(work(i));
  writer.join();
  EXPECT_EQ(recovered(folder.path()), std::vector<std::uint64_t>{last});
}

}  // namespace
}  // namespace hariko
