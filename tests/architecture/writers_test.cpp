// Files are written by core/base/file_io, which leaves no halves; the rest is named here with its reason.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "tests/support/places.hpp"

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::string>& exceptions() {
  static const std::map<std::string, std::string> files = {
      {"core/base/files/file_io.cpp", "the one that leaves no halves"},
      {"app/input/replay.hpp", "grows while the user works: what is there is of use after a crash"},
      {"app/input/test_log.hpp", "likewise, for tests"},
      {"app/persistence/file_lock.cpp", "an empty file, for its lock"},
      {"core/base/files/temporary_files.cpp", "opens what it removes, for its lock"},
      {"app/start_program.cpp", "/dev/null for another program"},
      {"app/crash_report.cpp", "a crashed program can only make system calls"},
      {"app/persistence/run_log.cpp", "adds lines at the end of a log"},
  };
  return files;
}

TEST(Writers, NobodyWritesFilesByItself) {
  const fs::path top = hariko::test::source_folder();
  std::size_t seen = 0, excepted = 0;
  for (const char* layer : {"core", "render", "ui", "app"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(top / layer)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      ++seen;
      const std::string name = fs::relative(entry.path(), top).generic_string();
      if (exceptions().contains(name)) {
        ++excepted;
        continue;
      }
      std::ifstream file(entry.path());
      std::string text;
      for (int line = 1; std::getline(file, text); ++line)
        for (const char* word : {"ofstream", "std::fstream", "fopen(", "creat(", "O_WRONLY", "O_RDWR",
                                 "O_CREAT", "png_image_write_to_file", "freopen("})
          EXPECT_EQ(text.find(word), std::string::npos)
              << name << ":" << line << ": write_file_atomic writes files whole";
    }
  EXPECT_GT(seen, 50U) << "the sources were not found";
  EXPECT_EQ(excepted, exceptions().size()) << "an exception is not needed any more";
}

}  // namespace
