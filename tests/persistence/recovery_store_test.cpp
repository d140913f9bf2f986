// Recovery copies of several sessions: each session has its own, and only those of ended sessions are
// offered.

#include "app/persistence/recovery_store.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/document/file.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

Document named(const std::string& name) {
  return document_from_mesh(test::cube(), name).value();
}

/// A session in a process of its own, which writes a copy and is killed: what a crash leaves behind.
void crashed_session(const fs::path& folder, const Document& document, const RecoveryNote& note) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    auto slot = RecoveryStore(folder).create(0).value();
    SystemFileLayer layer;
    if (slot.write(document, note, layer)) ::kill(::getpid(), SIGKILL);
    ::_exit(1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

class RecoveryStoreTest : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
  fs::path state_ = folder_.path() / "state" / "recovery";
  fs::path original_ = folder_.path() / "model.hariko";
  RecoveryStore store_{state_};
  SystemFileLayer layer_;
};

TEST_F(RecoveryStoreTest, NothingIsLeftByASessionThatClearedOrNeverWrote) {
  EXPECT_TRUE(store_.leftovers(0).empty()) << "a folder that does not exist";
  {
    auto slot = test::must(store_.create(0));
    ASSERT_TRUE(store_.create(0).ok()) << "a second window";
  }
  {
    RecoverySlot slot = store_.create(0).value();
    ASSERT_TRUE(slot.write(named("a"), {}, layer_));
    ASSERT_TRUE(slot.clear(layer_));
  }
  EXPECT_TRUE(store_.leftovers(0).empty());
  EXPECT_TRUE(fs::is_empty(state_)) << "folders and locks went with their sessions";
}

TEST_F(RecoveryStoreTest, ACrashIsOfferedUntilItIsCleared) {
  crashed_session(state_, named("work"), {original_, {}, 12});
  auto found = store_.leftovers(0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].note.original, original_);
  EXPECT_EQ(found[0].note.written_at, 12);
  EXPECT_EQ(found[0].objects, 1U);
  EXPECT_FALSE(found[0].damaged);
  EXPECT_TRUE(load_document(found[0].copy).value() == named("work")) << "a picture can be made of it";
  EXPECT_EQ(store_.leftovers(0).size(), 1U) << "looking does not take";
  {
    const auto slot = test::must(store_.adopt(found[0].id, 0));
    EXPECT_TRUE(read_recovery(slot->folder())->document == named("work"));
    EXPECT_EQ(store_.adopt(found[0].id, 0).error().code, e_recovery_taken) << "another window recovers it";
    EXPECT_TRUE(store_.leftovers(0).empty()) << "it has a living session again";
  }
  ASSERT_EQ(store_.leftovers(0).size(), 1U) << "recovered, but neither saved nor discarded: still there";
  {
    RecoverySlot slot = store_.adopt(found[0].id, 0).value();
    ASSERT_TRUE(slot.clear(layer_));
  }
  EXPECT_TRUE(store_.leftovers(0).empty());
  EXPECT_EQ(store_.adopt(found[0].id, 0).error().code, e_no_recovery);
  EXPECT_EQ(store_.adopt("../model", 0).error().code, e_no_recovery);
  EXPECT_TRUE(fs::is_empty(state_));
}

TEST_F(RecoveryStoreTest, SessionsDoNotTouchEachOthersCopies) {
  RecoverySlot alive = store_.create(0).value();
  ASSERT_TRUE(alive.write(named("alive"), {original_, {}, 1}, layer_));
  crashed_session(state_, named("first"), {original_, {}, 2});
  crashed_session(state_, named("second"), {original_, {}, 3});
  const auto found = store_.leftovers(0);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].note.written_at, 3) << "latest first";
  ASSERT_TRUE(RecoverySlot(store_.adopt(found[0].id, 0).value()).clear(layer_));
  ASSERT_EQ(store_.leftovers(0).size(), 1U);
  EXPECT_TRUE(read_recovery(alive.folder())->document == named("alive"));
  EXPECT_EQ(store_.adopt(alive.folder().filename().string(), 0).error().code, e_recovery_taken);
}

TEST_F(RecoveryStoreTest, WhatWasSavedIsNotOffered) {
  // Killed after the save and before the copy was removed.
  ASSERT_TRUE(save_document(named("work"), original_));
  crashed_session(state_, named("work"), {original_, {}, 1});
  EXPECT_TRUE(store_.leftovers(0).empty());
  EXPECT_TRUE(fs::is_empty(state_));
}

TEST_F(RecoveryStoreTest, ABrokenNewerOriginalDoesNotHideTheCopy) {
  ASSERT_TRUE(save_document(named("old"), original_));
  const auto stamp = stamp_of(original_);
  ASSERT_TRUE(stamp);
  crashed_session(state_, named("work"), {original_, stamp, 1});
  EXPECT_FALSE(store_.leftovers(0).at(0).file_changed);
  test::spill(original_, "{\"hariko\": ");
  fs::last_write_time(original_, fs::file_time_type::clock::now() + std::chrono::hours(10));
  const auto found = store_.leftovers(0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].file_changed) << "and it is said that the file is another one now";
  EXPECT_TRUE(load_document(found[0].copy).value() == named("work"));
}

TEST_F(RecoveryStoreTest, DamageIsSaidAndHarmsNoOther) {
  crashed_session(state_, named("good"), {original_, {}, 1});
  crashed_session(state_, named("bad"), {original_, {}, 2});
  test::spill(store_.leftovers(0).at(0).copy, "zeros");
  const auto found = store_.leftovers(0);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].damaged);
  EXPECT_EQ(found[0].note.original, original_);
  EXPECT_FALSE(found[1].damaged);
}

TEST_F(RecoveryStoreTest, SaysWhyNothingCanBeKept) {
  test::spill(folder_.path() / "file", "");
  test::must_fail(RecoveryStore(folder_.path() / "file" / "recovery").create(0), e_recovery_folder);
}

}  // namespace
}  // namespace hariko
