#include "app/crash_report.hpp"

#include <signal.h>

#include <cstdlib>
#include <ctime>
#include <regex>

#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

TEST(CrashReportDeathTest, NamesTheSignalAndEndsByIt) {
  EXPECT_EXIT((report_crashes(), static_cast<void>(::raise(SIGSEGV))), ::testing::KilledBySignal(SIGSEGV),
              "hariko crashed: SEGV\n(.*\n)+");
  EXPECT_EXIT((report_crashes(), std::abort()), ::testing::KilledBySignal(SIGABRT), "hariko crashed: ABRT");
}

/// Each call keeps something of its own on the stack, so that the recursion cannot become a loop.
int deeper(volatile char* before, int depth) {
  volatile char own[4096];
  own[0] = *before;
  return depth == 0 ? own[0] : deeper(own, depth - 1) + own[0];
}

TEST(CrashReportDeathTest, ReportsAnOverflownStack) {
  volatile char start = 0;
  EXPECT_EXIT((report_crashes(), static_cast<void>(deeper(&start, 1 << 24))),
              ::testing::KilledBySignal(SIGSEGV), "hariko crashed: SEGV");
}

/// The report that a child leaves which crashes after `prepare`.
template <class Prepare>
std::string report_of_child(const std::filesystem::path& file, Prepare&& prepare) {
  EXPECT_EXIT((report_crashes(), prepare(), static_cast<void>(::raise(SIGSEGV))),
              ::testing::KilledBySignal(SIGSEGV), "hariko crashed: SEGV\n(.*\n)+");
  return std::filesystem::exists(file) ? test::slurp(file) : "no file";
}

TEST(CrashReportDeathTest, KeepsAReportWithWhatIsKnown) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "not there" / "crash-1.txt";
  const std::string text = report_of_child(file, [&] {
    keep_crash_reports(file, "Hariko 1");
    keep_crash_reports(file, "Hariko 1\nOpenGL 3.3");
  });
  std::smatch time;
  ASSERT_TRUE(std::regex_search(
      text, time,
      std::regex(
          "^hariko crashed: SEGV\n(\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d) UTC\nHariko 1\nOpenGL 3.3\n")))
      << text;
  std::tm utc{};
  ASSERT_NE(::strptime(time[1].str().c_str(), "%Y-%m-%d %H:%M:%S", &utc), nullptr);
  EXPECT_NEAR(std::difftime(std::time(nullptr), ::timegm(&utc)), 0, 600);
  // A line for each call, with its address.
  EXPECT_TRUE(std::regex_search(text, std::regex("(\\[0x[0-9a-f]+\\]\n[^\n]*){3}"))) << text;
}

TEST(CrashReportDeathTest, WithoutAPlaceTheStandardErrorSaysItAll) {
  const test::TemporaryFolder folder;
  test::spill(folder.path() / "file", "");
  const auto impossible = folder.path() / "file" / "crash-1.txt";
  EXPECT_EQ(report_of_child(impossible, [&] { keep_crash_reports(impossible, "Hariko 1"); }), "no file");
  const auto too_long = folder.path() / std::string(5000, 'x');
  report_of_child(folder.path() / "none", [&] { keep_crash_reports(too_long, std::string(9000, 'y')); });
  EXPECT_EQ(test::files_in(folder.path()), 1U) << "a report at another place";
}

}  // namespace
}  // namespace hariko
