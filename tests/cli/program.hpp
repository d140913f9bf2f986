#pragma once

// Runs the program and keeps what it said.

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
