#include "tests/cli/program.hpp"

namespace hariko::test {
namespace {

class Usage : public ProgramTest {};

TEST_F(Usage, HelpAndVersion) {
  const Outcome help = run("--help");
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word : {"info", "export", "render", "evaluate", "unfold", "Exit codes"})
    EXPECT_NE(help.out.find(word), std::string::npos) << word;
  for (const std::string command : {"info", "export", "render", "evaluate", "unfold"}) {
    const Outcome own = run(command + " --help");
    EXPECT_EQ(own.exit_code, 0) << command;
    EXPECT_NE(own.out.find("FILE"), std::string::npos) << command;
  }
  const Outcome version = run("--version");
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.rfind("hariko ", 0), 0U);
}

TEST_F(Usage, WrongArgumentsGiveTwo) {
  const std::string cube = golden("cube.obj");
  for (const std::string& arguments :
       std::vector<std::string>{std::string("info"),
                                "info " + cube + " " + cube,
                                "info --unknown " + cube,
                                std::string("info --json"),
                                "export " + cube,
                                "export " + cube + " " + path("a.foo"),
                                "export " + cube + " " + path("a.dae"),
                                "export " + cube + " " + path("a"),
                                "export " + cube + " " + path("a.obj") + " --density 0",
                                "export " + cube + " " + path("a.obj") + " --density 257",
                                "export " + cube + " " + path("a.obj") + " --density many",
                                "export " + cube + " " + cube,
                                "render " + cube,
                                "render " + cube + " " + path("a.jpg"),
                                "render " + cube + " " + path("a.png") + " --size 100",
                                "render " + cube + " " + path("a.png") + " --size 0x9",
                                "render " + cube + " " + path("a.png") + " --size 9000x9",
                                "render " + cube + " " + path("a.png") + " --size 10x10x10",
                                "render " + cube + " " + path("a.png") + " --view inside",
                                "render " + cube + " " + path("a.png") + " --map heat",
                                "render " + cube + " " + path("a.png") + " --show faces",
                                "render " + cube + " " + path("a.png") + " --format svg",
                                "render " + cube + " " + path("a") + " --format jpg",
                                std::string("evaluate"),
                                "evaluate " + cube + " --mode cubic",
                                "evaluate " + cube + " --tension"}) {
    const Outcome result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_TRUE(result.out.empty()) << arguments;
    EXPECT_FALSE(result.error.empty()) << arguments;
  }
  EXPECT_FALSE(std::filesystem::exists(path("a.obj")));
  EXPECT_FALSE(std::filesystem::exists(path("a.png")));
}

TEST_F(Usage, WrongInputGivesOne) {
  write_text(path("broken.obj"), "v 0 0\n");
  write_text(path("broken.hariko"), "{");
  for (const std::string& file :
       {path("missing.obj"), path("missing.hariko"), path("broken.obj"), path("broken.hariko")})
    for (const std::string& arguments : {"info " + file, "export " + file + " " + path("a.obj"),
                                         "render " + file + " " + path("a.png"), "evaluate " + file}) {
      const Outcome result = run(arguments);
      EXPECT_EQ(result.exit_code, 1) << arguments;
      EXPECT_NE(result.error.find("error E_"), std::string::npos) << arguments << "\n" << result.error;
    }
  EXPECT_FALSE(std::filesystem::exists(path("a.obj")));
  EXPECT_FALSE(std::filesystem::exists(path("a.png")));
}

TEST_F(Usage, FullDiskGivesOne) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no device that is always full";
  const std::string command =
      "'" HARIKO_PROGRAM "' evaluate " + golden("cube.obj") + " >/dev/full 2>/dev/null";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
}

}  // namespace
}  // namespace hariko::test
