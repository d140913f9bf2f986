#include "app/persistence/run_log.hpp"

#include <cstdlib>
#include <regex>
#include <sstream>

#include "tests/support/temporary_folder.hpp"

namespace hariko::test {
namespace {

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::istringstream in(slurp(file));
  std::vector<std::string> out;
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

TEST(RunLog, ALineSaysWhenWhoAndWhat) {
  const test::TemporaryFolder folder;
  const auto state = folder.path() / "not" / "there yet";
  const RunLog log(state);
  log.line("opened", "vase.hariko");
  log.line("error", "E_X: two\nlines \x01 and \xff");
  const auto lines = lines_of(state / "log.txt");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(
      std::regex_match(lines[0], std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ \d+ opened vase\.hariko)")))
      << lines[0];
  EXPECT_TRUE(lines[1].ends_with("error E_X: two?lines ? and ?")) << lines[1];
}

TEST(RunLog, SeveralWindowsWriteToOneFile) {
  const test::TemporaryFolder folder;
  const RunLog first(folder.path()), second(folder.path());
  first.line("start", "a");
  second.line("start", "b");
  first.line("end", "0");
  EXPECT_EQ(lines_of(folder.path() / "log.txt").size(), 3U);
}

TEST(RunLog, NamesOfTheUsersFolderAreLeftOut) {
  const test::TemporaryFolder folder;
  const char* old = std::getenv("HOME");
  const std::string before = old ? old : "";
  ::setenv("HOME", "/home/ada", 1);
  const RunLog log(folder.path());
  if (old)
    ::setenv("HOME", before.c_str(), 1);
  else
    ::unsetenv("HOME");
  log.line("error", "\"/home/ada/secret.obj\" and /home/ada/b");
  EXPECT_TRUE(lines_of(folder.path() / "log.txt").at(0).ends_with("error \"~/secret.obj\" and ~/b"));
}

TEST(RunLog, StaysSmall) {
  const test::TemporaryFolder folder;
  const RunLog log(folder.path());
  const std::string text(900, 'x');
  for (int i = 0; i < 700; ++i) log.line("error", std::to_string(i) + text);  // more than twice the limit
  EXPECT_EQ(test::files_in(folder.path()), 2U);
  for (const char* name : {"log.txt", "log.old.txt"})
    EXPECT_LE(std::filesystem::file_size(folder.path() / name), RunLog::largest + 2000) << name;
  EXPECT_NE(lines_of(folder.path() / "log.txt").back().find("error 699x"), std::string::npos);
  // One text alone cannot fill it either.
  log.line("error", std::string(1 << 20, 'y'));
  EXPECT_LT(lines_of(folder.path() / "log.txt").back().size(), 2000U);
}

TEST(RunLog, TheTailIsWholeLines) {
  const test::TemporaryFolder folder;
  const RunLog log(folder.path());
  EXPECT_EQ(log.tail(100), "");
  spill(folder.path() / "log.txt", "first\nsecond\nthird\n");
  EXPECT_EQ(log.tail(1000), "first\nsecond\nthird\n");
  EXPECT_EQ(log.tail(10), "third\n");
  EXPECT_EQ(log.tail(2), "");
}

TEST(RunLog, NothingStopsForIt) {
  const test::TemporaryFolder folder;
  spill(folder.path() / "file", "");
  const RunLog impossible(folder.path() / "file" / "folder"), none{std::filesystem::path()};
  impossible.line("start", "a");
  none.line("start", "a");
  EXPECT_EQ(impossible.tail(100), "");
  EXPECT_EQ(none.tail(100), "");
  // A log that is a folder.
  std::filesystem::create_directory(folder.path() / "log.txt");
  const RunLog taken(folder.path());
  taken.line("start", "a");
  EXPECT_EQ(taken.tail(100), "");
}

}  // namespace
}  // namespace hariko::test
