#pragma once

// Runs the program and keeps what it said.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/support/places.hpp"

namespace hariko::test {

using Json = nlohmann::json;

inline std::string read_text(const std::filesystem::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// The model of this name in tests/golden.
inline std::string golden(const std::string& name) {
  return test::source_folder() + "/tests/golden/" + name;
}

struct Outcome {
  int exit_code = -1;  ///< -1 when it was killed
  std::string out, error;

  Json json() const { return Json::parse(out, nullptr, false); }
  /// The one object of `info --json`.
  Json object() const {
    const Json all = json();
    EXPECT_TRUE(all.is_object() && all.contains("objects") && all["objects"].size() == 1) << out;
    return all.is_object() && all.contains("objects") && all["objects"].size() == 1 ? all["objects"][0]
                                                                                    : Json();
  }
};

/// Grid of `side` times `side` vertices at jumping heights, as OBJ: quads that are not flat, or their halves.
inline std::string bumpy_grid(int side, bool triangles = false) {
  std::ostringstream out;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) out << "v " << i << ' ' << j << ' ' << (7 * i + 13 * j) % 5 << '\n';
  for (int j = 0; j + 1 < side; ++j)
    for (int i = 1; i < side; ++i) {
      const int a = j * side + i, b = a + 1, c = b + side, d = a + side;
      if (triangles)
        out << "f " << a << ' ' << b << ' ' << c << "\nf " << a << ' ' << c << ' ' << d << '\n';
      else
        out << "f " << a << ' ' << b << ' ' << c << ' ' << d << '\n';
    }
  return out.str();
}

/// A test with a folder of its own, removed afterwards.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "hariko-cli-XXXXXX").string();
    const char* made = mkdtemp(pattern.data());
    EXPECT_NE(made, nullptr);
    folder_ = pattern;
  }
  ~ProgramTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// `arguments` as a shell would split them. Runs without a display, with a log of its own.
  /// `input`: file that is its standard input.
  Outcome run(const std::string& arguments, const std::string& input = "/dev/null") const {
    // Threads of the graphics driver end while the leak checker looks at their stacks, which stops the
    // checker.
    const bool draws = arguments.starts_with("render ");
    const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY XDG_STATE_HOME='" + path("state") + "' " +
                                std::string(draws ? "ASAN_OPTIONS=detect_leaks=0 " : "") + "'" +
                                program_path() + "' " + arguments + " >'" + path("stdout.txt") + "' 2>'" +
                                path("stderr.txt") + "' <'" + input + "'";
    const int status = std::system(command.c_str());
    Outcome out;
    out.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    out.out = read_text(path("stdout.txt"));
    out.error = read_text(path("stderr.txt"));
    return out;
  }
  /// Text that comes to the error stream where that is a terminal; the results go to stdout.txt.
  std::string shown_on_terminal(const std::string& arguments) const {
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    EXPECT_TRUE(terminal >= 0 && ::grantpt(terminal) == 0 && ::unlockpt(terminal) == 0);
    if (terminal < 0) return {};
    const std::string name = ::ptsname(terminal);
    const int kept = ::open(name.c_str(), O_RDWR | O_NOCTTY);  // text that was written stays until it is read
    const std::string command = "env -u DISPLAY XDG_STATE_HOME='" + path("state") + "' '" + program_path() +
                                "' " + arguments + " >'" + path("stdout.txt") + "' 2>'" + name +
                                "' </dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << arguments;
    ::fcntl(terminal, F_SETFL, O_NONBLOCK);
    std::string shown;
    char piece[4096];
    for (ssize_t got = 0; (got = ::read(terminal, piece, sizeof piece)) > 0;)
      shown.append(piece, std::size_t(got));
    ::close(kept);
    ::close(terminal);
    return shown;
  }
  /// The same of what has to end well; where it does not the test fails, at the line of the call, and ends.
  Outcome succeed(const std::string& arguments, const std::string& input = "/dev/null",
                  const char* file = __builtin_FILE(), int line = __builtin_LINE()) const {
    Outcome out = run(arguments, input);
    if (out.exit_code != 0) {
      ADD_FAILURE_AT(file, line) << arguments << " ended with " << out.exit_code << "\n" << out.error;
      throw std::runtime_error("the program did not end well");
    }
    return out;
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace hariko::test
