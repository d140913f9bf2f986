#pragma once

// Standard input and output in the place of files: "-" as FILE or OUT.

#include <filesystem>
#include <memory>
#include <string>

#include "app/scratch_folder.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hariko {

/// Input is a file in a folder of its own until the program ends, and output becomes one
/// first, so that nothing is written where a job fails. While a file goes to the standard output, reports go
/// to the standard error stream.
class StandardStreams {
 public:
  StandardStreams() = default;
  ~StandardStreams();
  StandardStreams(const StandardStreams&) = delete;
  StandardStreams& operator=(const StandardStreams&) = delete;

  /// Gives the command options --from, and --to where it has an OUT, after these were added.
  void add_to(CLI::App& command);
  /// After parsing: --from and --to are for "-" only. Throws CLI::ValidationError.
  void check() const;
  /// After the job: writes OUT to the standard output. `code`: of the job; gives it, or 1.
  int finish(int code);

 private:
  std::string input(const CLI::Option& from);
  std::string output(const CLI::Option& to);
  const std::filesystem::path& folder();

  std::unique_ptr<ScratchFolder> folder_;
  std::filesystem::path in_, out_;  ///< empty where a file is named
  int saved_output_ = -1;
  std::string from_, to_;
};

}  // namespace hariko
