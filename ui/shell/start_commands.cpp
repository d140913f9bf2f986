// The guided first model.

#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"

namespace hariko {

namespace {

void start_guide(Editor& editor) {
  if (!editor.has_document) editor.open({}, {});
  editor.guide.start({editor.history.current(), editor.exports});
}

}  // namespace

void add_start_commands(CommandHost& host) {
  Editor& editor = host.editor;
  host.table.add({.id = "help.guide",
                  .menu = "Help",
                  .label = "Your first model",
                  .help = "Make a model in two minutes, step by step.",
                  .icon = icon::info,
                  .while_tool_runs = true,
                  .needs_window = true,
                  .run = [&editor] { start_guide(editor); },
                  .checked = [&editor] { return editor.guide.shown(); }});
}

}  // namespace hariko
