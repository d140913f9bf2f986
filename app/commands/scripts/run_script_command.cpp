#include <cstdio>
#include <optional>
#include <string>

#include "app/commands/commands.hpp"
#include "app/commands/console.hpp"
#include "app/commands/document_input.hpp"
#include "app/commands/scripts/command_list.hpp"
#include "app/scripts/script_file.hpp"
#include "app/scripts/script_session.hpp"
#include "core/base/files/file_io.hpp"
#include "core/base/text/nearest_word.hpp"
#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

namespace {

constexpr Code w_script_written{"W_SCRIPT_WRITTEN"};
constexpr Code w_script_left_out{"W_SCRIPT_LEFT_OUT"};
constexpr std::uint64_t largest_script = std::uint64_t(64) << 20;  ///< bytes

Message at_step(std::size_t index, const ScriptStep& step, const std::string& text) {
  return make_error(e_script_step, "At " + step_text(index, step.command) + ": " + text);
}

/// Text of a message without what stands before it in the line of a report.
std::string sentence_of(const Message& message) {
  return message.remedy.empty() ? message.text : message.text + " " + message.remedy;
}

Message unknown_command_at(std::size_t index, const ScriptStep& step, const CommandTable& table) {
  std::vector<std::string> known;
  for (const Command& command : table.all()) known.push_back(command.id);
  const auto near = nearest_word(step.command, known);
  return at_step(index, step,
                 "There is no such command." + (near ? " Did you mean \"" + *near + "\"?" : std::string()));
}

/// Finds what is wrong with a step before anything runs; lengths are checked when their unit is known.
std::optional<Message> wrong_step(std::size_t index, const ScriptStep& step, const CommandTable& table) {
  const Command* command = table.find(step.command);
  if (!command) return unknown_command_at(index, step, table);
  if (!command->scriptable()) return at_step(index, step, needs_the_window);
  const auto arguments = read_arguments(command->script.arguments, step.arguments, std::nullopt);
  if (!arguments) return at_step(index, step, sentence_of(arguments.error()));
  return {};
}

Message edits_left_out(std::size_t count) {
  return make_warning(
      w_script_left_out,
      (count == 1 ? "1 edit is" : std::to_string(count) + " edits are") +
          " missing in this script: they were made while it was recorded, and have no command.",
      "Its member \"notes\" says which, and between which steps.");
}

class ScriptRun {
 public:
  explicit ScriptRun(const ScriptArguments& arguments)
      : arguments_(arguments), session_([&arguments](const std::filesystem::path& path) {
          return open_as_asked(path, arguments.reading);
        }) {}

  int run() {
    const auto text = read_file(arguments_.file, largest_script);
    if (!text) return failed(text.error());
    const auto script = read_script(*text);
    if (!script) return failed(script.error());
    const std::vector<ScriptStep>& steps = script->steps;
    for (std::size_t i = 0; i < steps.size(); ++i)
      if (const auto wrong = wrong_step(i, steps[i], session_.commands())) return failed(*wrong);
    if (script->left_out > 0) report(arguments_.file.string(), edits_left_out(script->left_out));
    if (const auto opened = open_input(); !opened) return failed(opened.error());
    for (std::size_t i = 0; i < steps.size(); ++i)
      if (const auto done = run_step(i, steps[i]); !done) return failed(done.error());
    return finish();
  }

 private:
  Result<Done> open_input() {
    if (!arguments_.in) return Done{};
    auto opened = session_.open_document(*arguments_.in);
    return tell() ? opened : Result<Done>(output_failed());
  }

  Result<Done> run_step(std::size_t index, const ScriptStep& step) {
    const Command& command = *session_.commands().find(step.command);
    const Editor& editor = session_.editor();
    const Unit unit = editor.has_document ? editor.document().unit : editor.settings.unit;
    const auto arguments = read_arguments(command.script.arguments, step.arguments, unit);
    if (!arguments) return at_step(index, step, sentence_of(arguments.error()));
    const auto done = session_.run(command, *arguments);
    if (!tell()) return output_failed();
    if (!done) return at_step(index, step, sentence_of(done.error()));
    return Done{};
  }

  /// Prints what was said: warnings to the error stream, all else to the output. False where that fails.
  bool tell() {
    bool printed = true;
    for (const ScriptNote& note : session_.take_notes()) {
      if (note.kind == Notice::Kind::info)
        printed = printed && print(note.text + "\n");
      else
        report_line("warning " + note.text);
    }
    return printed;
  }

  int finish() {
    if (arguments_.out) {
      if (const auto saved = session_.save_document_to(*arguments_.out); !saved) return failed(saved.error());
    } else if (session_.unsaved()) {
      report(arguments_.file.string(),
             make_warning(w_script_unsaved, "The document has changes at the end that no step saved.",
                          "Save it by file.save, or name a file with --out."));
    }
    return exit_fine;
  }

  int failed(const Message& message) {
    report(arguments_.file.string(), message);
    std::string files;
    for (const std::filesystem::path& path : session_.written())
      files += (files.empty() ? "" : ", ") + sanitized_utf8(path.string());
    if (!files.empty())
      report(arguments_.file.string(),
             make_warning(w_script_written, "The steps before wrote " + files + "."));
    return exit_failed;
  }

  void report_line(const std::string& text) const {
    const std::string line = arguments_.file.string() + ": " + text + "\n";
    std::fwrite(line.data(), 1, line.size(), stderr);
  }

  static Message output_failed() {
    return make_error(e_output, "The script stopped because its output cannot be written.");
  }

  const ScriptArguments& arguments_;
  ScriptSession session_;
};

}  // namespace

int run_script(const ScriptArguments& arguments) {
  return ScriptRun(arguments).run();
}

int run_command_list(bool json) {
  const ScriptSession session([](const std::filesystem::path& path) { return open_file(path); });
  const std::string text =
      json ? command_list_json(session.commands()) : command_list_text(session.commands());
  return print(text) ? exit_fine : exit_failed;
}

}  // namespace hariko
