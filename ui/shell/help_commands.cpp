// Commands that help to find things: the palette, the cheat sheet, preferences, and what this program is.

#include <imgui.h>

#include "ui/base/icons.hpp"
#include "ui/base/system_information.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/shell/workbench.hpp"
#include "ui/widgets/application_services.hpp"

namespace hariko {

namespace {

constexpr const char* libraries =
    "Dear ImGui (MIT), GLFW (zlib), GLM (MIT), libepoxy (MIT), FreeType (FTL), fontconfig (MIT), Eigen (MPL "
    "2.0), oneTBB "
    "(Apache 2.0), "
    "JSON for Modern C++ (MIT), CLI11 (BSD), libpng (libpng), libjpeg-turbo (IJG). Inter, Font Awesome and "
    "Noto Sans CJK (SIL "
    "OFL).";

void show_about(Workbench& workbench, const Language& tr) {
  Prompt::Request request;
  request.title = tr("About Hariko");
  request.text = std::string(tr("Stretch a smooth surface over a rough structure.")) + "\n\n" +
                 system_information() + "\n\n" + tr("Libraries and fonts:") + "\n" + libraries;
  request.answers = {{tr("Close"), "close", {}}, {tr("Copy system information"), "copy", [] {
                                                    ImGui::SetClipboardText(system_information().c_str());
                                                  }}};
  workbench.ask(std::move(request));
}

void add_recording(CommandHost& host, Workbench& workbench) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  table.add({.id = "help.record",
             .menu = translatable("Help"),
             .label = translatable("Record a replay\u2026"),
             .help = translatable("Write what you do from here on to a file that plays it again."),
             .separator_before = true,
             .while_tool_runs = true,
             .needs_window = true,
             .run = [&workbench] { workbench.files().record(); },
             .why_not = only_if(
                 needs_document(editor), [&editor] { return !editor.recording; },
                 translatable("A replay is being recorded already."))});
  table.add({.id = "help.stop_recording",
             .menu = translatable("Help"),
             .label = translatable("Stop recording"),
             .help = translatable("End the replay that is being recorded."),
             .while_tool_runs = true,
             .needs_window = true,
             .run = [&host] { host.application.stop_recording(); },
             .why_not = only_if([&editor] { return editor.recording; },
                                translatable("No replay is being recorded."))});
}

}  // namespace

void add_help_commands(CommandHost& host, Workbench& workbench) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  table.add({.id = "help.palette",
             .menu = translatable("Help"),
             .label = translatable("Search commands\u2026"),
             .help = translatable("Find any command or object by a few letters of its name."),
             .keys = "F3 / Ctrl+Shift+P",
             .icon = icon::search,
             .while_tool_runs = true,
             .needs_window = true,
             .run = [&workbench] { workbench.show_palette(); }});
  table.add({.id = "help.keys",
             .menu = translatable("Help"),
             .label = translatable("Keys at a glance"),
             .help = translatable("Show every key, those of the present tool first."),
             .keys = "F1 / ?",
             .icon = icon::keyboard,
             .while_tool_runs = true,
             .needs_window = true,
             .run = [&workbench] { workbench.show_cheat_sheet(); }});
  table.add({.id = "help.context_menu",
             .menu = translatable("Help"),
             .label = translatable("Menu at the pointer"),
             .help = translatable("What can be done with what is under the pointer."),
             .keys = "Menu / Shift+F10",
             .while_tool_runs = true,
             .needs_window = true,
             .run = [&workbench] { workbench.show_context_menu(); },
             .why_not = needs_document(editor)});
  add_recording(host, workbench);
  table.add({.id = "help.log",
             .menu = translatable("Help"),
             .label = translatable("Open the log folder"),
             .help = translatable("Show the files that a report about a mistake of the program needs."),
             .while_tool_runs = true,
             .needs_window = true,
             .run = [&host] { host.application.show_log_folder(); }});
  table.add({.id = "help.about",
             .menu = translatable("Help"),
             .label = translatable("About Hariko"),
             .help = translatable("Version, graphics driver and licences."),
             .icon = icon::info,
             .separator_before = true,
             .while_tool_runs = true,
             .needs_window = true,
             .run = [&workbench, &editor] { show_about(workbench, editor.language); }});
}

void add_preferences_commands(CommandHost& host, Workbench& workbench) {
  CommandTable& table = host.table;
  table.add({.id = "edit.preferences",
             .menu = translatable("Edit"),
             .label = translatable("Preferences\u2026"),
             .help = translatable("Language, theme, navigation, units, keys."),
             .keys = "Ctrl+,",
             .icon = icon::settings,
             .separator_before = true,
             .needs_window = true,
             .run = [&workbench] { workbench.show_preferences(); }});
  table.add({.id = "edit.export_keys",
             .menu = "Edit",
             .label = translatable("Export keys\u2026"),
             .help = translatable("Write the keys that are not the default ones to a file."),
             .needs_window = true,
             .run = [&workbench] { workbench.files().export_keys(); }});
  table.add({.id = "edit.import_keys",
             .menu = "Edit",
             .label = translatable("Import keys\u2026"),
             .help = translatable("Take the keys of a file in place of those that are in use."),
             .needs_window = true,
             .run = [&workbench] { workbench.files().import_keys(); }});
}

}  // namespace hariko
