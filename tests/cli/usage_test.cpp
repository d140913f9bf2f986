#include <map>
#include <regex>
#include <set>
#include <utility>

#include "tests/cli/program.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {
namespace {

class Usage : public ProgramTest {};

TEST_F(Usage, HelpAndVersion) {
  const Outcome help = succeed("--help");
  for (const char* word : {"info", "export", "render", "evaluate", "unfold", "run", "Exit codes"})
    EXPECT_NE(help.out.find(word), std::string::npos) << word;
  for (const std::string command : {"info", "export", "render", "sections", "evaluate", "unfold", "run"}) {
    const Outcome own = succeed(command + " --help");
    EXPECT_NE(own.out.find("FILE"), std::string::npos) << command;
  }
  const Outcome version = succeed("--version");
  EXPECT_EQ(version.out.rfind("hariko ", 0), 0U);
}

TEST_F(Usage, LongWorkSaysOnATerminalHowFarItIs) {
  write_text(path("grid.obj"), bumpy_grid(60));
  write_text(path("flat.obj"), bumpy_grid(60, true));
  const std::string grid = path("grid.obj"), flat = path("flat.obj");
  const std::pair<std::string, const char*> commands[] = {
      {"export " + grid + " " + path("grid.stl") + " --density 8", "grid.stl: writing "},
      {"mesh " + grid + " " + path("grid.ply") + " --distance 0.8", "grid.ply: meshing "},
      {"unfold " + flat + " " + path("flat.json") + " --height 30", "flat.obj: unfolding "}};
  for (const auto& [command, line] : commands) {
    const std::string shown = shown_on_terminal(command);
    const std::size_t found = shown.find(line);
    EXPECT_NE(found, std::string::npos) << command << "\n" << shown;
    EXPECT_NE(shown.find(" %", found), std::string::npos) << "no share of the work: " << shown;
    EXPECT_NE(shown.rfind("\r\033[K"), std::string::npos) << "the line stays";
    EXPECT_EQ(run(command).error.find(line), std::string::npos) << "a line where nobody looks";
  }
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
                                "mesh " + cube + " " + path("a.obj") + " --normal nan",
                                "export " + cube + " " + path("a.obj") + " --angle NaN",
                                "unfold " + cube + " " + path("a.pdf") + " --merge nan",
                                "unfold " + cube + " " + path("a.pdf") + " --margin inf",
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

TEST_F(Usage, AMisspeltCommandIsToldWithTheNearest) {
  const std::string cube = golden("cube.obj");
  for (const auto& [arguments, meant] :
       std::map<std::string, std::string>{{"exprot " + cube + " " + path("b.obj"), "export"},
                                          {"exprot " + cube + " " + path("b.obj") + " --density 3", "export"},
                                          {"Render " + cube + " " + path("b.png"), "render"},
                                          {"unfld", "unfold"},
                                          {"eval " + cube, "evaluate"},
                                          {"--width 900 inof", "info"},
                                          {"help", "--help"}}) {
    const Outcome result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_TRUE(result.out.empty()) << arguments;
    EXPECT_NE(result.error.find("is neither a command nor a file"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("Did you mean '" + meant + "'?"), std::string::npos) << result.error;
  }
  const Outcome far = run("quux");
  EXPECT_EQ(far.exit_code, 2);
  EXPECT_EQ(far.error.find("Did you mean"), std::string::npos) << far.error;
  EXPECT_FALSE(std::filesystem::exists(path("b.obj")));
}

TEST_F(Usage, AMisspeltOptionIsToldWithTheNearest) {
  const std::string cube = golden("cube.obj");
  for (const auto& [arguments, meant] : std::map<std::string, std::string>{
           {"--widht 900", "--width"},
           {"--scal=2 " + cube, "--scale"},
           {"export " + cube + " " + path("a.obj") + " --densty 3", "--density"},
           {"export " + cube + " " + path("a.obj") + " --densty=3", "--density"},
           {"info --jsn " + cube, "--json"},
           {"mesh " + cube + " " + path("a.obj") + " --dist 1", "--distance"}}) {
    const Outcome result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_NE(result.error.find("Did you mean '" + meant + "'?"), std::string::npos) << arguments << "\n"
                                                                                     << result.error;
  }
  // Hidden words are not proposed either.
  EXPECT_EQ(run("--test-lgo x").error.find("Did you mean '--test-log'"), std::string::npos);
}

TEST_F(Usage, TheWindowsOptionsStandWithoutACommand) {
  const std::string cube = golden("cube.obj");
  for (const std::string& arguments : {"--width 900 info " + cube, cube + " info " + cube,
                                       "--replay x.jsonl render " + cube + " " + path("a.png")}) {
    const Outcome result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_NE(result.error.find("is for the window"), std::string::npos) << result.error;
  }
  for (const std::string arguments :
       {"--width 0", "--height -3", "--width wide", "--scale 9", "--skip-pauses", "--record a --replay b"}) {
    const Outcome result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_TRUE(result.out.empty()) << arguments;
  }
}

/// These tests have no display: what asks for the window gets as far as that.
TEST_F(Usage, FilesOpenTheWindow) {
  const std::string cube = golden("cube.obj");
  write_text(path("plain"), "");
  for (const std::string& arguments :
       {std::string(), cube, cube + " " + cube, path("plain"), "--width 900 --height 700 " + cube,
        "--test-log " + path("log.jsonl"), std::string("./info")}) {
    const Outcome result = run(arguments);
    EXPECT_EQ(result.exit_code, 1) << arguments;
    EXPECT_NE(result.error.find("No window can be opened"), std::string::npos) << arguments << "\n"
                                                                               << result.error;
  }
}

TEST_F(Usage, AMissingFileIsToldBeforeTheWindowOpens) {
  const Outcome result = run(path("nothere.hariko"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.error.find("nothere.hariko: error E_FILE_OPEN: There is no such file."), std::string::npos)
      << result.error;
  // A word with a folder is a file, too, whatever its ending.
  EXPECT_NE(run("models/export").error.find("models/export: error E_FILE_OPEN"), std::string::npos);
}

using Names = std::set<std::string>;

Names options_in(const std::string& text) {
  static const std::regex option("--[a-z][a-z0-9-]*");
  Names out;
  for (std::sregex_iterator it(text.begin(), text.end(), option), end; it != end; ++it) out.insert(it->str());
  return out;
}

/// The options that docs/cli.md names for each command in its synopsis and its tables; "" is the window.
std::map<std::string, Names> documented() {
  std::istringstream lines(read_text(source_folder() + "/docs/cli.md"));
  std::map<std::string, Names> out;
  std::string place;
  bool synopsis = false;
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    if (line.starts_with("```")) synopsis = !synopsis && out.empty();
    if (std::regex_search(line, found, std::regex(synopsis ? "^hariko ([a-z]+)" : "^## ([a-z]+)")))
      place = found[1];
    else if (line.starts_with("hariko "))
      place = "";
    if (!synopsis && !(line.starts_with("| `--") && !place.empty())) continue;
    // The first column of a table names options, the others describe them.
    const std::string named = synopsis ? line : line.substr(0, line.find(" | ", 2));
    out[place].merge(options_in(named));
  }
  return out;
}

TEST_F(Usage, HelpNamesAllThatIsDocumented) {
  const auto places = documented();
  ASSERT_GE(places.size(), 7U);
  const std::string all = run("--help").out;
  Names unnamed_commands;
  for (const auto& [command, options] : places) {
    if (!command.empty() && all.find("\n  " + command + " ") == std::string::npos)
      unnamed_commands.insert(command);
    const Names shown = options_in(command.empty() ? all : run(command + " --help").out);
    for (const std::string& option : options)
      EXPECT_TRUE(shown.contains(option)) << "`hariko " << command << " --help` does not name " << option;
  }
  EXPECT_EQ(unnamed_commands, Names());
  for (const char* option : {"--width", "--height", "--scale", "--record", "--replay", "--skip-pauses"})
    EXPECT_TRUE(options_in(all).contains(option)) << option;
  EXPECT_FALSE(options_in(all).contains("--test-log"));
}

TEST_F(Usage, AllThatHelpNamesIsDocumented) {
  const Names documented = options_in(read_text(source_folder() + "/docs/cli.md"));
  for (const std::string command :
       {"", "info", "export", "render", "mesh", "sections", "evaluate", "unfold", "run"})
    for (const std::string& option : options_in(run(command + " --help").out))
      EXPECT_TRUE(documented.contains(option)) << "docs/cli.md does not name " << option << " of " << command;
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
      "'" + program_path() + "' evaluate " + golden("cube.obj") + " >/dev/full 2>/dev/null";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
}

}  // namespace
}  // namespace hariko::test
