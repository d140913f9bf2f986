#include "app/persistence/crash_reports.hpp"

#include <unistd.h>

#include <chrono>

#include "tests/support/temporary_folder.hpp"

namespace hariko::test {
namespace {

void write_report(const std::filesystem::path& file, const std::string& text, std::chrono::hours age) {
  spill(file, text);
  std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now() - age);
}

TEST(CrashReports, TheLatestIsOfferedUntilItIsDismissed) {
  const test::TemporaryFolder folder;
  const CrashReports reports(folder.path());
  EXPECT_FALSE(reports.latest());
  write_report(folder.path() / "crash-12.txt", "older", std::chrono::hours(30));
  write_report(folder.path() / "crash-7.txt", "newer", std::chrono::hours(2));
  const auto found = reports.latest();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->file.filename(), "crash-7.txt");
  EXPECT_EQ(found->text, "newer");
  const std::int64_t now =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
          .count();
  EXPECT_NEAR(double(now - found->written_at), 2 * 3600, 60);

  reports.dismiss();
  EXPECT_FALSE(reports.latest());
  EXPECT_EQ(test::files_in(folder.path()), 1U);
  EXPECT_EQ(test::slurp(folder.path() / "crash.txt"), "newer") << "it is still there to be sent";
}

TEST(CrashReports, OtherFilesAreNone) {
  const test::TemporaryFolder folder;
  for (const char* name :
       {"crash.txt", "crash-.txt", "crash-a.txt", "crash-1.txt.gz", "log.txt", "recent.json"})
    spill(folder.path() / name, name);
  const CrashReports reports(folder.path());
  EXPECT_FALSE(reports.latest());
  reports.dismiss();
  EXPECT_EQ(test::files_in(folder.path()), 6U);
}

TEST(CrashReports, TheOwnFileIsOneOfThem) {
  const test::TemporaryFolder folder;
  const CrashReports reports(folder.path());
  EXPECT_EQ(reports.own_file(), folder.path() / ("crash-" + std::to_string(::getpid()) + ".txt"));
  spill(reports.own_file(), "own");
  ASSERT_TRUE(reports.latest());
  EXPECT_EQ(reports.latest()->text, "own");
}

TEST(CrashReports, AFolderThatIsNotThereHasNone) {
  const test::TemporaryFolder folder;
  const CrashReports reports(folder.path() / "none");
  EXPECT_FALSE(reports.latest());
  reports.dismiss();
}

}  // namespace
}  // namespace hariko::test
