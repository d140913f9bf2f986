#include "app/commands/command_line/standard_streams.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <optional>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/files/file_kind.hpp"
#include "core/base/files/file_io.hpp"

namespace hariko {

namespace {

constexpr std::size_t piece_size = 65536;

const std::vector<std::string> read_formats{"hariko", "obj", "off",  "ply",  "stl", "glb",  "gltf",
                                            "3mf",    "bpt", "json", "step", "stp", "iges", "igs"};
const std::vector<std::string> written_formats{"obj", "off",  "ply", "stl", "3mf", "glb", "gltf", "step",
                                               "stp", "iges", "igs", "png", "svg", "pdf", "dxf",  "json"};

// The parser puts the name of the argument before errors of these functions.

std::string read_all_input() {
  std::string out;
  std::vector<char> piece(piece_size);
  while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), stdin)) {
    out.append(piece.data(), got);
    if (out.size() > default_file_size_limit)
      throw CLI::ValidationError("the standard input is longer than files may be");
  }
  return out;
}

bool write_all(int file, const std::filesystem::path& from) {
  std::ifstream in(from, std::ios::binary);
  std::vector<char> piece(piece_size);
  while (in.read(piece.data(), std::streamsize(piece.size())), in.gcount() > 0) {
    const char* at = piece.data();
    for (std::streamsize left = in.gcount(); left > 0;) {
      const ssize_t written = ::write(file, at, std::size_t(left));
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      at += written;
      left -= written;
    }
  }
  return in.eof();
}

}  // namespace

StandardStreams::~StandardStreams() {
  if (saved_output_ >= 0) ::close(saved_output_);
}

void StandardStreams::add_to(CLI::App& command) {
  const auto* from =
      command.add_option("--from", from_, "Format of FILE where that is -, the standard input")
          ->check(CLI::IsMember(read_formats));
  command.get_option("FILE")->transform(
      [this, from](std::string name) { return name == "-" ? input(*from) : name; }, "");
  CLI::Option* out = command.get_option_no_throw("OUT");
  if (!out) return;
  const auto* to = command.add_option("--to", to_, "Format of OUT where that is -, the standard output")
                       ->check(CLI::IsMember(written_formats));
  out->transform([this, to](std::string name) { return name == "-" ? output(*to) : name; }, "");
}

const std::filesystem::path& StandardStreams::folder() {
  if (!folder_) {
    // A reader that ends early ends writing with an error; as a signal it would leave the folder behind.
    std::signal(SIGPIPE, SIG_IGN);
    folder_ = std::make_unique<ScratchFolder>();
  }
  if (folder_->path().empty()) throw CLI::ValidationError("no temporary file can be made");
  return folder_->path();
}

void StandardStreams::read(CLI::Option& option, std::string format) {
  option.transform([this, name = option.get_name(), format = std::move(format)](
                       std::string value) { return value == "-" ? keep_input(name, format) : value; },
                   "");
}

void StandardStreams::write(CLI::Option& option, std::string format) {
  option.transform([this, format = std::move(format)](
                       std::string value) { return value == "-" ? redirect_output(format) : value; },
                   "");
}

std::string StandardStreams::input(const CLI::Option& from) {
  return keep_input("FILE", from.empty() ? std::string() : from.results().front());
}

/// `name`: of the argument, for messages.
std::string StandardStreams::keep_input(const std::string& name, const std::string& format) {
  if (!in_.empty() && reader_ != name)
    throw CLI::ValidationError("only one file can come from the standard input");
  if (!in_.empty()) return in_.string();
  const std::string bytes = read_all_input();
  const auto ending = format.empty() ? ending_of_content(bytes) : std::optional(format);
  if (!ending)
    throw CLI::ValidationError(name == "FILE"
                                   ? "the standard input does not tell its format; say it with --from"
                                   : "the standard input does not tell its format; name a file");
  in_ = folder() / ("input." + *ending);
  reader_ = name;
  if (!write_file_atomic(in_, bytes).ok())
    throw CLI::ValidationError("the standard input cannot be kept in a temporary file");
  return in_.string();
}

std::string StandardStreams::output(const CLI::Option& to) {
  if (to.empty()) throw CLI::ValidationError("say with --to which format the standard output gets");
  return redirect_output(to.results().front());
}

std::string StandardStreams::redirect_output(const std::string& format) {
  if (!out_.empty()) throw CLI::ValidationError("only one file can go to the standard output");
  out_ = folder() / ("output." + format);
  // Reports of the commands go to the error stream.
  saved_output_ = ::dup(STDOUT_FILENO);
  if (saved_output_ < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
    throw CLI::ValidationError("the standard output cannot be written");
  return out_.string();
}

void StandardStreams::check() const {
  if (in_.empty() && !from_.empty()) throw CLI::ValidationError("--from", "is for - as FILE");
  if (out_.empty() && !to_.empty()) throw CLI::ValidationError("--to", "is for - as OUT");
}

/// Number of files that the job wrote into the scratch folder.
std::size_t StandardStreams::written_files() const {
  std::error_code unknown;
  std::size_t out = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out_.parent_path(), unknown))
    out += entry.path() != in_ ? 1 : 0;
  return out;
}

int StandardStreams::finish(int code) {
  if (out_.empty() || code != exit_fine) return code;
  if (written_files() > 1) {
    report("",
           make_error(e_output,
                      "The job makes several files, and the standard output holds one: nothing was written.",
                      "Choose a format that holds all pages, such as pdf, or name a file."));
    return exit_failed;
  }
  if (write_all(saved_output_, out_)) return code;
  report("", make_error(e_output, "The result could not be written to the standard output.",
                        "Check that the disk is not full and that the reading program still runs."));
  return exit_failed;
}

}  // namespace hariko
