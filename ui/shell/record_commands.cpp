// Writing what is done as a script, which `hariko run` repeats.

#include "ui/base/icons.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/shell/workbench.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko {

void add_record_commands(CommandHost& host, Workbench& workbench) {
  Editor& editor = host.editor;
  host.table.add({.id = "edit.record_script",
                  .menu = "Edit",
                  .label = translatable("Record a script\u2026"),
                  .help = translatable("Write the commands that you use from here on to a file that repeats "
                                       "them without the window."),
                  .icon = icon::record,
                  .separator_before = true,
                  .needs_window = true,
                  .run = [&workbench] { workbench.files().record_script(); },
                  .why_not = only_if(
                      needs_document(editor), [&editor] { return !editor.script_recording; },
                      translatable("A script is being recorded already."))});
  host.table.add({.id = "edit.stop_script",
                  .menu = "Edit",
                  .label = translatable("Stop the script"),
                  .help = translatable("End the script that is being recorded, and write its file."),
                  .while_tool_runs = true,
                  .needs_window = true,
                  .run = [&host] { host.application.stop_script(); },
                  .why_not = only_if([&editor] { return editor.script_recording.has_value(); },
                                     translatable("No script is being recorded."))});
}

}  // namespace hariko
