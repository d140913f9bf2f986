// Exports that do not fit: a limit on the size of files, a device that is always full, a folder that is not
// writable.

#include <sys/resource.h>
#include <unistd.h>

#include "core/cad/kernel/cad_file.hpp"
#include "tests/cli/program.hpp"

namespace hariko::test {
namespace {

namespace fs = std::filesystem;

/// For files of this process and of those that it starts, bytes.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limited{bytes, before_.rlim_max};
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &limited), 0);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

class FullDisk : public ProgramTest {
 protected:
  /// But for what the program said.
  std::size_t files() const {
    std::size_t out = 0;
    for (const auto& entry : fs::directory_iterator(path("")))
      out += entry.path().filename() != "stdout.txt" && entry.path().filename() != "stderr.txt";
    return out;
  }
  std::vector<std::string> exports() const {
    const std::string model = golden("cube.obj");
    std::vector<std::string> out;
    for (const char* ending : {"obj", "off", "ply", "stl", "3mf", "glb", "gltf"})
      out.push_back("export " + model + " " + path("a.") + ending + " --density 32");
    if (!why_no_cad_files())
      for (const char* ending : {"step", "iges"})
        out.push_back("export " + model + " " + path("a.") + ending);
    for (const char* ending : {"svg", "dxf", "pdf", "json"})
      out.push_back("unfold " + golden("unfolding/dome_opt.obj") + " " + path("a.") + ending +
                    " --width 200 --steps 10");
    return out;
  }
};

TEST_F(FullDisk, AFileThatDoesNotFitIsNotThere) {
  for (const std::string& arguments : exports()) {
    SCOPED_TRACE(arguments);
    const FileSizeLimit limit(8192);
    const Outcome result = run(arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.error.find("E_FILE_WRITE"), std::string::npos) << result.error;
    EXPECT_EQ(files(), 0U);
  }
}

TEST_F(FullDisk, AFileThatDoesNotFitDoesNotReplaceAnother) {
  const std::string out = path("a.stl");
  write_text(out, "an old one");
  const Outcome result = [&] {
    const FileSizeLimit limit(8192);
    return run("export " + golden("cube.obj") + " " + out);
  }();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(read_text(out), "an old one");
  EXPECT_EQ(files(), 1U);
}

TEST_F(FullDisk, DevicesAreNotReplaced) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no device that is always full";
  fs::create_symlink("/dev/full", path("a.stl"));
  const Outcome result = run("export " + golden("cube.obj") + " " + path("a.stl"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.error.find("it is not a regular file"), std::string::npos) << result.error;
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_EQ(files(), 1U);
}

TEST_F(FullDisk, FoldersThatAreNotWritableAreSaidToBe) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const fs::path closed = path("closed");
  fs::create_directory(closed);
  fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
  const Outcome result = run("export " + golden("cube.obj") + " " + (closed / "a.stl").string());
  fs::permissions(closed, fs::perms::owner_all);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.error.find("Permission denied"), std::string::npos) << result.error;
  EXPECT_TRUE(fs::is_empty(closed));
}

}  // namespace
}  // namespace hariko::test
