#include "app/commands/command_line/subcommand_lines.hpp"

#include <CLI/CLI.hpp>

#include "core/base/files/file_ending.hpp"

namespace hariko {

void ScriptCommandLine::add_to(CLI::App& app, StandardStreams& streams) {
  command_ = app.add_subcommand("run", "Runs a script: commands of the window, without the window");
  CLI::Option* file = command_->add_option("FILE", file_, "Script (*.json)");
  CLI::Option* in = command_->add_option("--in", in_, "Document or mesh to begin with, instead of none");
  CLI::Option* out = command_->add_option("--out", out_, "Document to save at the end: *.hariko");
  command_->add_flag("--list", list_, "Prints every command and its arguments instead");
  command_->add_flag("--json", json_, "Prints them as JSON");
  streams.read(*file, "json");
  streams.read(*in, "");
  streams.write(*out, "hariko");
  reading_.add_to(*command_);
}

void ScriptCommandLine::check() const {
  if (json_ && !list_) throw CLI::ValidationError("--json", "is for --list");
  if (list_ && (!file_.empty() || !in_.empty() || !out_.empty()))
    throw CLI::ValidationError("--list", "stands alone, or with --json");
  if (!list_ && file_.empty()) throw CLI::RequiredError("FILE");
  if (!out_.empty() && lower_ending(out_) != ".hariko")
    throw CLI::ValidationError("--out",
                               "the name must end in .hariko; steps file.export write other formats");
}

int ScriptCommandLine::run() const {
  if (list_) return run_command_list(json_);
  ScriptArguments arguments;
  arguments.file = file_;
  if (!in_.empty()) arguments.in = in_;
  if (!out_.empty()) arguments.out = out_;
  arguments.reading = reading_.reading();
  return run_script(arguments);
}

}  // namespace hariko
