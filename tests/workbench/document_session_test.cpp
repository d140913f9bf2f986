// The open document and its file, driven as the window drives it: samples, saving, locks, changes by other
// programs, recovery.

#include <algorithm>
#include <chrono>

#include "core/document/words.hpp"
#include "tests/support/places.hpp"
#include "tests/workbench/session_rig.hpp"

namespace hariko::test {
namespace {

TEST(DocumentSession, ASampleOpensAsACopyWithoutAFile) {
  const test::TemporaryFolder folder;
  const auto samples = folder.path() / "samples";
  std::filesystem::create_directory(samples);
  const auto sample = samples / "vase.hariko";
  ASSERT_TRUE(save_document(box("Vase"), sample).ok());
  const std::string bytes = test::slurp(sample);
  Session session(folder.path());
  session->open(sample);
  session.settle();
  ASSERT_EQ(session.editor().document().objects[0]->name, "Vase");
  EXPECT_FALSE(session.editor().path.has_value());
  EXPECT_FALSE(session.editor().history.dirty());
  EXPECT_EQ(session.editor().title(), "vase copy");
  EXPECT_EQ(test::files_in(samples), 1U) << "a lock beside the sample";
  // It is no file of the user's.
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "state" / "recent.json"));

  session.rename_object("Mine");
  session.bench().key("Ctrl+S");
  session.settle();
  EXPECT_TRUE(session.shows("dialog.name")) << "saving does not ask for a name";
  EXPECT_EQ(test::slurp(sample), bytes);
}

TEST(DocumentSession, AnotherFileOfTheSameNameIsNoSample) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "samples");
  const auto file = folder.path() / "vase.hariko";
  ASSERT_TRUE(save_document(box("Vase"), file).ok());
  Session session(folder.path());
  session->open(file);
  session.settle();
  EXPECT_EQ(session.editor().path, file);
  EXPECT_TRUE(std::filesystem::exists(lock_path_of(file)));
}

TEST_F(OpenFile, SavingWritesTheDocumentAndCountsAsSaved) {
  session_->rename_object("Changed");
  EXPECT_TRUE(session_->editor().history.dirty());
  save();
  EXPECT_EQ(name_in(file_), "Changed");
  EXPECT_FALSE(session_->editor().history.dirty());
  EXPECT_TRUE(session_->happened("saved"));
}

TEST_F(OpenFile, AFileThatWasOnlyTouchedIsOverwrittenWithoutAQuestion) {
  session_->rename_object("Changed");
  std::filesystem::last_write_time(file_, std::filesystem::file_time_type::clock::now());
  save();
  EXPECT_EQ(name_in(file_), "Changed");
}

TEST_F(OpenFile, AFileThatAnotherProgramChangedIsAskedAbout) {
  session_->rename_object("Mine");
  ASSERT_TRUE(save_document(box("Theirs"), file_).ok());
  save();
  ASSERT_TRUE(session_->shows("prompt.overwrite"));
  session_->bench().key("Esc");
  session_->settle();
  EXPECT_FALSE(session_->shows("prompt.overwrite"));
  EXPECT_EQ(name_in(file_), "Theirs");
  EXPECT_TRUE(session_->editor().history.dirty());

  save();
  session_->click("prompt.save_as");
  EXPECT_TRUE(session_->shows("dialog.name"));
  session_->bench().key("Esc");
  session_->settle();
  EXPECT_EQ(name_in(file_), "Theirs");

  save();
  session_->click("prompt.overwrite");
  session_->settle();
  EXPECT_EQ(name_in(file_), "Mine");
  EXPECT_FALSE(session_->editor().history.dirty());
  // The file that was read or written last is known again.
  session_->rename_object("Again");
  save();
  EXPECT_EQ(name_in(file_), "Again");
}

TEST_F(OpenFile, SavingAgainAtOnceIsNoChangeByAnotherProgram) {
  session_->rename_object("One");
  (*session_)->save(file_, {});
  session_->rename_object("Two");
  (*session_)->save(file_, {});
  session_->settle();
  EXPECT_FALSE(session_->shows("prompt.overwrite"));
  EXPECT_EQ(name_in(file_), "Two");
  EXPECT_FALSE(session_->editor().history.dirty());
}

TEST_F(OpenFile, WhatIsToBeWrittenIsWrittenBeforeTheEnd) {
  const auto copy = folder_.path() / "copy.hariko";
  session_->rename_object("Changed");
  (*session_)->save(file_, {});
  (*session_)->save_copy(copy);
  (*session_)->end();
  session_.reset();
  EXPECT_EQ(name_in(file_), "Changed");
  EXPECT_EQ(name_in(copy), "Changed");
}

TEST_F(OpenFile, WhatIsBeingSavedUnderAnotherNameLeavesTheOldFile) {
  const auto other = folder_.path() / "other.hariko";
  session_->rename_object("One");
  (*session_)->save(other, {});
  session_->rename_object("Two");
  session_->bench().key("Ctrl+S");
  session_->settle();
  EXPECT_EQ(name_in(file_), "Saved");
  EXPECT_EQ(name_in(other), "Two") << last_notice();
  EXPECT_EQ(session_->editor().path, other);
  EXPECT_FALSE(session_->editor().history.dirty());
}

TEST_F(OpenFile, RevertIsAStepThatCanBeUndone) {
  session_->rename_object("Mine");
  (*session_)->revert();
  session_->settle();
  EXPECT_EQ(session_->editor().document().objects[0]->name, "Saved");
  EXPECT_FALSE(session_->editor().history.dirty());
  session_->editor().undo();
  EXPECT_EQ(session_->editor().document().objects[0]->name, "Mine");
  EXPECT_TRUE(session_->editor().history.dirty());
}

TEST_F(OpenFile, SavingSweepsUpWhatAKilledSaveLeft) {
  const auto left = folder_.path() / ".hariko-2147483646-0.tmp";  // above the highest number of a process
  test::spill(left, "half");
  std::filesystem::last_write_time(left,
                                   std::filesystem::file_time_type::clock::now() - std::chrono::minutes(1));
  session_->rename_object("Mine");
  save();
  EXPECT_FALSE(std::filesystem::exists(left));
}

TEST_F(OpenFile, AFileThatIsOpenElsewhereIsReadOnlyOrACopy) {
  const auto other = folder_.path() / "other.hariko";
  ASSERT_TRUE(save_document(box("Other"), other).ok());
  const auto held = FileLock::try_lock(lock_path_of(other), 0);  // as another window does
  ASSERT_EQ(held.outcome, FileLock::Attempt::Outcome::acquired);

  (*session_)->open(other);
  session_->settle();
  ASSERT_TRUE(session_->shows("prompt.read_only"));
  session_->bench().key("Esc");
  session_->settle();
  EXPECT_EQ(session_->editor().path, file_) << "no answer opens nothing";

  (*session_)->open(other);
  session_->settle();
  session_->click("prompt.read_only");
  EXPECT_EQ(session_->editor().path, other);
  EXPECT_TRUE(session_->editor().read_only);
  session_->rename_object("Changed");
  save();
  EXPECT_TRUE(session_->shows("dialog.name")) << "a read-only file is saved under another name";
  session_->bench().key("Esc");
  // The dialog lets the name be chosen; the lock does not.
  (*session_)->save(other, {});
  session_->settle();
  EXPECT_EQ(name_in(other), "Other");
  EXPECT_NE(last_notice().find("another window"), std::string::npos) << last_notice();

  (*session_)->open(other);
  session_->settle();
  session_->click("prompt.copy");
  EXPECT_FALSE(session_->editor().path.has_value());
  EXPECT_EQ(session_->editor().title(), "other copy");
}

TEST_F(OpenFile, WorkThatIsDoneWhileAnotherFileIsReadIsAskedAbout) {
  const auto other = folder_.path() / "other.hariko";
  ASSERT_TRUE(save_document(box("Other"), other).ok());
  (*session_)->open(other);
  session_->rename_object("Meanwhile");
  session_->settle();
  EXPECT_EQ(session_->editor().document().objects[0]->name, "Meanwhile") << "work is lost without a question";
  ASSERT_TRUE(session_->shows("prompt.discard"));
  session_->bench().key("Esc");
  session_->settle();
  EXPECT_EQ(session_->editor().document().objects[0]->name, "Meanwhile");
  EXPECT_EQ(FileLock::try_lock(lock_path_of(other), 0).outcome, FileLock::Attempt::Outcome::acquired);

  (*session_)->open(other);
  session_->rename_object("Once more");
  session_->settle();
  session_->click("prompt.discard");
  EXPECT_EQ(session_->editor().document().objects[0]->name, "Other");
  EXPECT_EQ(session_->editor().path, other);
  EXPECT_EQ(session_->bench().workbench().question(), nullptr) << "asked twice";
}

TEST_F(OpenFile, WhatIsMeantForADocumentWaitsForTheFileThatIsBeingOpened) {
  int calls = 0;
  const auto call = [&] {
    ++calls;
    EXPECT_EQ(session_->editor().path, file_);
  };
  (*session_)->when_opened(call);
  EXPECT_EQ(calls, 1) << "a document is open";
  session_->bench().workbench().close_document();
  (*session_)->open(file_);
  (*session_)->when_opened(call);
  EXPECT_EQ(calls, 1) << "the file would take the place of what is imported before it";
  session_->settle();
  EXPECT_EQ(calls, 2);
}

TEST_F(OpenFile, AnotherDocumentGivesTheLockBack) {
  EXPECT_EQ(FileLock::try_lock(lock_path_of(file_), 0).outcome, FileLock::Attempt::Outcome::taken);
  session_->editor().open({}, {});
  session_->settle();
  EXPECT_EQ(FileLock::try_lock(lock_path_of(file_), 0).outcome, FileLock::Attempt::Outcome::acquired);
}

TEST_F(OpenFile, OutlinesByEqualAnglesAreToldWhenTheirDocumentOpens) {
  Document document = load_document(test::source_folder() + "/assets/samples/saddle.hariko").value();
  for (const Frames frames : {Frames::metric, Frames::equal, Frames::metric}) {
    SCOPED_TRACE(std::string(enum_word(frames)));
    document = set_frames(document, document.objects[0]->id, frames).value();
    const auto file = folder_.path() / (std::string(enum_word(frames)) + ".hariko");
    ASSERT_TRUE(save_document(document, file).ok());
    (*session_)->open(file);
    session_->settle();
    ASSERT_EQ(session_->editor().path, file);
    const auto& notices = session_->editor().notices();
    const bool told = std::any_of(notices.begin(), notices.end(), [](const Notice& notice) {
      return notice.text.find("Surfaces by measure") != std::string::npos;
    });
    EXPECT_EQ(told, frames == Frames::equal);
  }
}

/// Work of a session that was killed: what `session` holds is written, and the session is gone.
void kill_with_work(std::optional<Session>& session) {
  (*session)->update();
  (*session)->write_autosave();
  session.reset();
}

class Recovery : public OpenFile {
 protected:
  void start_again() {
    session_.emplace(folder_.path());
    pictures_.emplace(session_->bench().renderer(), work_, folder_.path() / "cache");
    (*session_)->find_offers(*pictures_);
    reserved_ = session_->bench().workbench().offers().recovery_places;
    session_->settle();
  }
  const std::vector<RecoveryOffer>& offers() { return session_->bench().workbench().offers().recoveries; }
  void TearDown() override {
    pictures_.reset();
    session_.reset();
  }

  std::size_t reserved_ = 0;  ///< places on the start page before any copy was read
  Editor of_pictures_;
  BackgroundWork work_{of_pictures_, {}};
  std::optional<Pictures> pictures_;
};

TEST_F(Recovery, KilledWorkIsOfferedAndComesBackWithItsFile) {
  session_->rename_object("Not saved");
  kill_with_work(session_);
  EXPECT_EQ(name_in(file_), "Saved");
  start_again();
  EXPECT_EQ(reserved_, 1U) << "the card pushes the files below it down";
  ASSERT_EQ(offers().size(), 1U);
  EXPECT_EQ(offers()[0].path, file_);
  EXPECT_FALSE(offers()[0].file_changed);
  const auto& recent = session_->bench().workbench().offers().recent;
  ASSERT_EQ(recent.size(), 1U);
  EXPECT_EQ(recent[0].path, file_);
  (*session_)->recover(offers()[0].id);
  session_->settle();
  EXPECT_EQ(session_->editor().document().objects[0]->name, "Not saved");
  EXPECT_EQ(session_->editor().path, file_);
  EXPECT_TRUE(session_->editor().history.dirty());
  EXPECT_EQ(name_in(file_), "Saved") << "recovering wrote the file";
  EXPECT_TRUE(offers().empty());
  // Killed again before it was saved: still there.
  kill_with_work(session_);
  start_again();
  ASSERT_EQ(offers().size(), 1U);
  (*session_)->recover(offers()[0].id);
  session_->settle();
  save();
  EXPECT_EQ(name_in(file_), "Not saved");
  (*session_)->end();
  start_again();
  EXPECT_TRUE(offers().empty()) << "saved work is offered again";
}

TEST_F(Recovery, WorkThatWasNeverSavedComesBackWithoutAFile) {
  session_->editor().open(box("Never saved"), {});
  session_->rename_object("Still never saved");
  kill_with_work(session_);
  start_again();
  ASSERT_EQ(offers().size(), 1U);
  EXPECT_TRUE(offers()[0].path.empty());
  (*session_)->recover(offers()[0].id);
  session_->settle();
  EXPECT_EQ(session_->editor().document().objects[0]->name, "Still never saved");
  EXPECT_FALSE(session_->editor().path.has_value());
}

TEST_F(Recovery, WorkDoneWhileTheFileBecomesAnotherComesBackWithThat) {
  const auto other = folder_.path() / "other.hariko";
  session_->rename_object("One");
  (*session_)->save(other, {});
  session_->rename_object("Two");
  session_->settle();
  ASSERT_TRUE(session_->editor().history.dirty());
  kill_with_work(session_);
  start_again();
  ASSERT_EQ(offers().size(), 1U);
  EXPECT_EQ(offers()[0].path, other);
  EXPECT_FALSE(offers()[0].file_changed);
}

TEST_F(Recovery, AutosaveFollowsTheChangeWithoutBeingAsked) {
  session_->rename_object("Changed");
  EXPECT_EQ((*session_)->due_in(), -1) << "the first change is written at once";
  session_->settle();
  EXPECT_TRUE(session_->happened("autosaved"));
  session_->rename_object("Changed again");
  const double due = (*session_)->due_in();
  EXPECT_GT(due, 0);
  EXPECT_LE(due, 25) << "30 seconds are promised";
  session_->editor().now += 30;
  (*session_)->update();
  session_->settle();
  session_.reset();
  start_again();
  ASSERT_EQ(offers().size(), 1U);
  (*session_)->recover(offers()[0].id);
  session_->settle();
  EXPECT_EQ(session_->editor().document().objects[0]->name, "Changed again");
}

TEST_F(Recovery, ALivingWindowsWorkIsNotOffered) {
  session_->rename_object("Changed");
  (*session_)->write_autosave();
  const RecoveryStore store(folder_.path() / "state" / "recovery");
  EXPECT_TRUE(store.leftovers(0).empty());
  (*session_)->end();
  session_.reset();
  EXPECT_TRUE(store.leftovers(0).empty()) << "what was discarded at the end is kept";
}

TEST_F(Recovery, DiscardingAsksByNameAndRemovesTheWork) {
  session_->rename_object("Not saved");
  kill_with_work(session_);
  start_again();
  ASSERT_EQ(offers().size(), 1U);
  const std::string id = offers()[0].id;
  const RecoveryStore store(folder_.path() / "state" / "recovery");
  (*session_)->discard_recovery(id);
  session_->settle();
  ASSERT_TRUE(session_->shows("prompt.discard_recovery"));
  const Prompt::Request* question = session_->bench().workbench().question();
  ASSERT_NE(question, nullptr);
  EXPECT_NE(question->text.find("model.hariko"), std::string::npos) << question->text;
  session_->bench().key("Esc");
  session_->settle();
  EXPECT_EQ(store.leftovers(0).size(), 1U) << "Esc discarded the work";
  (*session_)->discard_recovery(id);
  session_->settle();
  session_->click("prompt.discard_recovery");
  EXPECT_TRUE(store.leftovers(0).empty());
  EXPECT_TRUE(offers().empty());
}

}  // namespace
}  // namespace hariko::test
