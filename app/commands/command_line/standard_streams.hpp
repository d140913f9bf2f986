#pragma once

// Standard input and output in place of files: "-" as FILE or OUT.

#include <filesystem>
#include <memory>
#include <string>

#include "app/scratch_folder.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hariko {

/// Redirection of standard streams through files. Input is copied to a file in a scratch folder for the life
/// of the program; output is written to such a file first, so that a failing job writes nothing. While a file
/// goes to the standard output, reports go to the standard error stream.
class StandardStreams {
 public:
  StandardStreams() = default;
  ~StandardStreams();
  StandardStreams(const StandardStreams&) = delete;
  StandardStreams& operator=(const StandardStreams&) = delete;

  /// Adds --from, and --to where the command has an OUT, after these arguments were added.
  void add_to(CLI::App& command);
  /// Lets "-" as the value of an option be the standard input in a format, which the first bytes tell where
  /// it is empty; or the standard output.
  void read(CLI::Option& option, std::string format);
  void write(CLI::Option& option, std::string format);
  /// Validates the options after parsing: --from and --to are for "-" only. Throws CLI::ValidationError.
  void check() const;
  /// Copies OUT to the standard output after the job. Returns the job's exit code `code`, or 1 on failure,
  /// which it also is where the job made several files, as a page each.
  int finish(int code);

 private:
  std::string input(const CLI::Option& from);
  std::string output(const CLI::Option& to);
  std::string keep_input(const std::string& name, const std::string& format);
  std::string redirect_output(const std::string& format);
  const std::filesystem::path& folder();
  std::size_t written_files() const;

  std::unique_ptr<ScratchFolder> folder_;
  std::filesystem::path in_, out_;  ///< empty where a file is named
  std::string reader_;              ///< the argument that is the standard input
  int saved_output_ = -1;
  std::string from_, to_;
};

}  // namespace hariko
