// Recovery copies: whatever fails while one is written, the old or the new one can be read; damage is seen.

#include "core/document/history/recovery.hpp"

#include "tests/document/random_documents.hpp"
#include "tests/support/failing_layer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

Document named(const std::string& name) {
  return document_from_mesh(test::cube(), name).value();
}

std::vector<fs::path> copies(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".hariko" && entry.path().filename().native()[0] != '.')
      found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Recovery, GivesDocumentAndNoteBack) {
  test::for_random(21, 30, [](std::mt19937_64& rng) {
    const test::TemporaryFolder folder;
    SystemFileLayer layer;
    for (int i = 0; i < 4; ++i) {
      const Document document = test::any_document(rng);
      RecoveryNote note{fs::path("/home/Größe/a\xff b.hariko"), FileStamp{5, -7, 1, ~std::uint64_t{0}},
                        1700000000 + i};
      if (test::chance(rng, 0.3)) note.original.clear();
      if (test::chance(rng, 0.3)) note.original_stamp.reset();
      ASSERT_TRUE(write_recovery(folder.path(), document, note, layer));
      const auto read = test::must(read_recovery(folder.path()));
      ASSERT_TRUE(read->document == document);
      ASSERT_TRUE(read->note == note);
      ASSERT_EQ(read_recovery_note(folder.path()), note);
      ASSERT_EQ(copies(folder.path()).size(), 1U) << "older copies stayed";
    }
    ASSERT_TRUE(remove_recovery(folder.path(), layer));
    ASSERT_TRUE(fs::is_empty(folder.path()));
    ASSERT_EQ(read_recovery(folder.path()).error().code, e_no_recovery);
    ASSERT_TRUE(remove_recovery(folder.path(), layer)) << "removing nothing is fine";
  });
}

TEST(Recovery, EveryFailingCallLeavesTheOldOrTheNewCopy) {
  const Document before = named("before"), after = named("after");
  const RecoveryNote old_note{"/old.hariko", {}, 1}, new_note{"/new.hariko", {}, 2};
  int failures = 0, after_found = 0;
  for (const bool dead : {false, true})
    for (const int error_number : {EIO, ENOSPC})
      for (int failing = 0;; ++failing) {
        SCOPED_TRACE("call " + std::to_string(failing) + (dead ? " and all later ones" : ""));
        const test::TemporaryFolder folder;
        SystemFileLayer system;
        ASSERT_TRUE(write_recovery(folder.path(), before, old_note, system));
        test::FailingLayer layer(failing, error_number, dead, 500);
        const auto written = write_recovery(folder.path(), after, new_note, layer);
        const auto read = test::must(read_recovery(folder.path()));
        ASSERT_TRUE(read->document == before || read->document == after);
        if (written) {
          ASSERT_TRUE(read->document == after);
          ASSERT_EQ(read->note, new_note);
        }
        failures += !written;
        after_found += read->document == after;
        // And it goes on when the disk does.
        ASSERT_TRUE(write_recovery(folder.path(), after, new_note, system));
        ASSERT_TRUE(read_recovery(folder.path())->document == after);
        if (layer.calls() <= failing) break;
      }
  EXPECT_GE(failures, 40);
  EXPECT_GE(after_found, 10);
}

TEST(Recovery, ADamagedCopyIsSeenAndAnOlderOneTaken) {
  const test::TemporaryFolder folder;
  SystemFileLayer layer;
  ASSERT_TRUE(write_recovery(folder.path(), named("old"), {"/a.hariko", {}, 1}, layer));
  const std::string old_text = test::slurp(copies(folder.path())[0]);
  ASSERT_TRUE(write_recovery(folder.path(), named("new"), {"/a.hariko", {}, 2}, layer));
  const fs::path copy = copies(folder.path())[0];
  const std::string text = test::slurp(copy);

  // Other bytes that still make a document, a truncated file, an empty one, zeros: none is taken for the
  // copy.
  std::string other = text;
  other.replace(other.find("new"), 3, "now");
  for (const std::string& bytes :
       {other, text.substr(0, text.size() / 2), std::string(), std::string(text.size(), '\0')}) {
    test::spill(copy, bytes);
    EXPECT_EQ(read_recovery(folder.path()).error().code, e_recovery_damaged);
  }
  test::spill(folder.path() / "copy-1.hariko", old_text);
  EXPECT_TRUE(read_recovery(folder.path())->document == named("old"));
  EXPECT_EQ(read_recovery(folder.path())->note.original, "/a.hariko");
  // The next copy is newer than all of these.
  ASSERT_TRUE(write_recovery(folder.path(), named("newest"), {}, layer));
  EXPECT_TRUE(read_recovery(folder.path())->document == named("newest"));
}

TEST(Recovery, ABrokenNoteCostsOnlyWhatItSays) {
  const test::TemporaryFolder folder;
  SystemFileLayer layer;
  for (const char* note :
       {"", "{", "[]", "{\"hariko_recovery\": 99}", "{\"hariko_recovery\": 1, \"copy\": \"x\"}",
        "{\"hariko_recovery\": 1, \"original\": 5, \"original_stamp\": {\"size\": []}}"}) {
    ASSERT_TRUE(write_recovery(folder.path(), named("a"), {"/a.hariko", {}, 5}, layer));
    test::spill(folder.path() / "recovery.json", note);
    const auto read = read_recovery(folder.path());
    ASSERT_TRUE(read) << note;
    EXPECT_TRUE(read->document == named("a"));
    EXPECT_TRUE(read->note.original.empty());
  }
}

}  // namespace
}  // namespace hariko
