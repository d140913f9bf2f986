// The guided first model.

#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"

namespace hariko {

void add_start_commands(CommandHost& host) {
  Editor& editor = host.editor;
  host.table.add({"help.guide",
                  "Help",
                  "Your first model",
                  "Make a model in two minutes, step by step.",
                  "",
                  icon::info,
                  false,
                  false,
                  [&editor] {
                    if (!editor.has_document) editor.open({}, {});
                    editor.guide.start({editor.history.current(), editor.exports});
                  },
                  {},
                  [&editor] { return editor.guide.shown(); }});
}

}  // namespace hariko
