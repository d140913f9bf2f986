#include "app/scripts/script_trial.hpp"

namespace hariko {

ScriptSession& ScriptTrial::session() {
  if (!session_) session_ = std::make_unique<ScriptSession>(open_file_);
  return *session_;
}

ScriptState ScriptTrial::start() {
  session_.reset();
  return {std::nullopt, circumstances_of(session().editor())};
}

std::optional<ScriptState> ScriptTrial::run(const ScriptState& from, std::span<const WrittenCommand> steps) {
  if (!from.document) session_.reset();  // a session cannot go back to before its first document
  Editor& editor = session().editor();
  if (from.document) editor.open(*from.document, std::nullopt);
  set_circumstances(editor, from.circumstances);
  for (const WrittenCommand& step : steps)
    if (!run_step(step)) {
      session_.reset();  // a tool or a question may be left of what failed
      return {};
    }
  session().take_notes();
  ScriptState out{std::nullopt, circumstances_of(editor)};
  if (editor.has_document) out.document = editor.history.current();
  return out;
}

bool ScriptTrial::run_step(const WrittenCommand& step) {
  const Command* command = session().commands().find(step.command);
  if (!command || !command->scriptable()) return false;
  const Editor& editor = session().editor();
  const Unit unit = editor.has_document ? editor.document().unit : editor.settings.unit;
  const auto arguments = read_arguments(command->script.arguments, step.arguments, unit);
  return arguments.ok() && session().run(*command, *arguments).ok();
}

}  // namespace hariko
