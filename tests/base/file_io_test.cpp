#include "core/base/files/file_io.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "core/base/text/sanitized_utf8.hpp"
#include "tests/support/failing_layer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko::test {
namespace {

std::size_t file_count(const std::filesystem::path& folder) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
  return count;
}

const std::string old_bytes("old\0bytes", 9);
const std::string new_bytes(100, 'n');

TEST(WriteFileAtomic, WritesAndReplacesAnyBytes) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "張り子 a.txt";
  for (const std::string& bytes : {std::string("a\0b", 3), std::string(), std::string(3'000'000, 'x')}) {
    ASSERT_TRUE(write_file_atomic(file, bytes).ok());
    EXPECT_EQ(slurp(file), bytes);
    EXPECT_EQ(read_file(file).value(), bytes);
    EXPECT_EQ(file_count(folder.path()), 1U);
  }
}

TEST(WriteFileAtomic, EveryFailingCallLeavesTheOldOrTheNewFile) {
  for (const bool existing : {true, false}) {
    for (const bool dead : {false, true}) {
      for (const int error_number : {EIO, ENOSPC}) {
        int failing = 0;
        for (;; ++failing) {
          SCOPED_TRACE("call " + std::to_string(failing) + " existing " + std::to_string(existing) +
                       " dead " + std::to_string(dead));
          const TemporaryFolder folder;
          const auto file = folder.path() / "model.hariko";
          if (existing) spill(file, old_bytes);
          FailingLayer layer(failing, error_number, dead);
          const auto result = write_file_atomic(file, new_bytes, layer);
          if (layer.calls() <= failing) {  // nothing failed any more
            EXPECT_TRUE(result.ok());
            EXPECT_EQ(slurp(file), new_bytes);
            break;
          }
          const bool replaced = layer.renames() > 0;
          if (replaced)
            EXPECT_EQ(slurp(file), new_bytes);
          else if (existing)
            EXPECT_EQ(slurp(file), old_bytes);
          else
            EXPECT_FALSE(std::filesystem::exists(file));
          if (!dead) {
            EXPECT_EQ(file_count(folder.path()), existing || replaced ? 1U : 0U);
          }
          // Closing the folder's descriptor is the one call whose failure means nothing.
          if (result.ok()) {
            EXPECT_TRUE(replaced);
            continue;
          }
          EXPECT_EQ(result.error().code, e_file_write);
          EXPECT_NE(result.error().text.find("model.hariko"), std::string::npos);
          EXPECT_NE(result.error().text.find(std::generic_category().message(error_number)),
                    std::string::npos);
        }
        // create, 15 writes, sync, close, rename, open folder, sync, close; and the mode of an existing file.
        EXPECT_EQ(failing, existing ? 23 : 22);
      }
    }
  }
}

TEST(WriteFileAtomic, InterruptedWritesAreRepeated) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a";
  FailingLayer layer(3, EINTR);
  EXPECT_TRUE(write_file_atomic(file, new_bytes, layer).ok());
  EXPECT_EQ(slurp(file), new_bytes);
}

TEST(WriteFileAtomic, TakesAnotherNameWhenTheTemporaryOneIsTaken) {
  const TemporaryFolder folder;
  const auto taken = folder.path() / (".hariko-" + std::to_string(::getpid()) + "-0.tmp");
  spill(taken, "of somebody else");
  EXPECT_TRUE(write_file_atomic(folder.path() / "a", new_bytes).ok());
  EXPECT_EQ(slurp(taken), "of somebody else");
  EXPECT_EQ(file_count(folder.path()), 2U);
}

TEST(WriteFileAtomic, KeepsPermissionsAndFollowsLinks) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "real");
  const auto target = folder.path() / "real" / "target";
  spill(target, old_bytes);
  ASSERT_EQ(::chmod(target.c_str(), 0640), 0);
  std::filesystem::create_symlink("real/target", folder.path() / "link");
  std::filesystem::create_symlink("link", folder.path() / "link of link");
  ASSERT_TRUE(write_file_atomic(folder.path() / "link of link", new_bytes).ok());
  EXPECT_EQ(slurp(target), new_bytes);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link of link"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link"));
  EXPECT_FALSE(std::filesystem::is_symlink(target));
  EXPECT_EQ(static_cast<unsigned>(std::filesystem::status(target).permissions()), 0640U);

  std::filesystem::create_symlink("real/later", folder.path() / "dangling");
  ASSERT_TRUE(write_file_atomic(folder.path() / "dangling", new_bytes).ok());
  EXPECT_EQ(slurp(folder.path() / "real" / "later"), new_bytes);
}

TEST(WriteFileAtomic, RefusesWhatIsNoFile) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("loop", folder.path() / "loop");
  ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  for (const auto& path : {folder.path(), folder.path() / "loop", folder.path() / "pipe",
                           folder.path() / "no" / "such", folder.path() / "", std::filesystem::path(),
                           std::filesystem::path("/dev/null"), folder.path() / std::string(300, 'x')}) {
    const auto result = write_file_atomic(path, new_bytes);
    ASSERT_FALSE(result.ok()) << path;
    EXPECT_EQ(result.error().code, e_file_write) << path;
  }
  EXPECT_EQ(file_count(folder.path()), 2U);
  const auto missing = write_file_atomic(folder.path() / "no" / "such", new_bytes);
  EXPECT_NE(missing.error().text.find("its folder does not exist"), std::string::npos)
      << missing.error().text;
}

TEST(WriteFileAtomic, RefusesWriteProtectedFiles) {
  if (::geteuid() == 0) GTEST_SKIP() << "nothing is protected from root";
  const TemporaryFolder folder;
  spill(folder.path() / "a", old_bytes);
  ASSERT_EQ(::chmod((folder.path() / "a").c_str(), 0400), 0);
  EXPECT_EQ(write_file_atomic(folder.path() / "a", new_bytes).error().code, e_file_write);
  EXPECT_EQ(slurp(folder.path() / "a"), old_bytes);
}

TEST(ReadFile, ErrorsNameTheFileAndTheReason) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  spill(folder.path() / "five", "12345");
  EXPECT_EQ(read_file(folder.path() / "none").error().code, e_file_open);
  EXPECT_NE(read_file(folder.path() / "none").error().text.find("none\" cannot be opened: No such file"),
            std::string::npos);
  EXPECT_EQ(read_file(folder.path()).error().code, e_file_open);
  EXPECT_EQ(read_file(folder.path() / "pipe").error().code, e_file_open);
  EXPECT_EQ(read_file("/dev/zero").error().code, e_file_open);
  EXPECT_EQ(read_file("/proc/self/mem").error().code, e_file_read);
  EXPECT_EQ(read_file(folder.path() / "five", 4).error().code, e_limit);
  EXPECT_EQ(read_file(folder.path() / "five", 5).value(), "12345");
}

TEST(Printable, KeepsUtf8AndReplacesTheRest) {
  EXPECT_EQ(sanitized_utf8("Grüße 張り子 🎏"), "Grüße 張り子 🎏");
  EXPECT_EQ(sanitized_utf8("a\nb\x7f\x01"), "a?b??");
  EXPECT_EQ(sanitized_utf8("\xff\xc0\x80\xed\xa0\x80\xf5\x80\x80\x80\xe5\xbc"), "????????????");
  EXPECT_EQ(sanitized_utf8("abcdef", 3), "abc...");
  EXPECT_EQ(sanitized_utf8("ab張", 4), "ab...");
  EXPECT_EQ(sanitized_utf8("abc", 3), "abc");
}

}  // namespace
}  // namespace hariko::test
