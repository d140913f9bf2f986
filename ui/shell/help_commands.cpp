// Commands that help to find things: the palette, the cheat sheet, preferences, and what this program is.

#include <imgui.h>

#include "ui/base/icons.hpp"
#include "ui/base/system_information.hpp"
#include "ui/shell/shell_commands.hpp"
#include "ui/shell/workbench.hpp"

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

}  // namespace

void add_help_commands(CommandHost& host, Workbench& workbench) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  table.add({"help.palette", translatable("Help"), translatable("Search commands\u2026"),
             translatable("Find any command or object by a few letters of its name."), "F3 / Ctrl+Shift+P",
             icon::search, false, false, [&workbench] { workbench.show_palette(); }});
  table.add({"help.keys", translatable("Help"), translatable("Keys at a glance"),
             translatable("Show every key, those of the present tool first."), "F1 / ?", icon::keyboard,
             false, false, [&workbench] { workbench.show_cheat_sheet(); }});
  table.add({"help.context_menu", translatable("Help"), translatable("Menu at the pointer"),
             translatable("What can be done with what is under the pointer."), "Menu / Shift+F10", "", false,
             false, [&workbench] { workbench.show_context_menu(); }, needs_document(editor)});
  table.add({"help.record", translatable("Help"), translatable("Record a replay\u2026"),
             translatable("Write what you do from here on to a file that plays it again."), "", "", false,
             true, [&workbench] { workbench.files().record(); },
             [&editor, document = needs_document(editor)]() -> Reason {
               if (auto reason = document()) return reason;
               if (editor.recording) return translatable("A replay is being recorded already.");
               return {};
             }});
  table.add({"help.stop_recording", translatable("Help"), translatable("Stop recording"),
             translatable("End the replay that is being recorded."), "", "", false, false,
             [&host] { host.application.stop_recording(); },
             [&editor]() -> Reason {
               if (editor.recording) return {};
               return translatable("No replay is being recorded.");
             }});
  table.add({"help.log", translatable("Help"), translatable("Open the log folder"),
             translatable("Show the files that a report about a mistake of the program needs."), "", "",
             false, false, [&host] { host.application.show_log_folder(); }});
  table.add({"help.about", translatable("Help"), translatable("About Hariko"),
             translatable("Version, graphics driver and licences."), "", icon::info, false, true,
             [&workbench, &editor] { show_about(workbench, editor.language); }});
}

void add_preferences_commands(CommandHost& host, Workbench& workbench) {
  CommandTable& table = host.table;
  table.add({"edit.preferences", translatable("Edit"), translatable("Preferences\u2026"),
             translatable("Language, theme, navigation, units, keys."), "Ctrl+,", icon::settings, false, true,
             [&workbench] { workbench.show_preferences(); }});
  table.add({"edit.export_keys", "Edit", translatable("Export keys\u2026"),
             translatable("Write the keys that are not the default ones to a file."), "", "", false, false,
             [&workbench] { workbench.files().export_keys(); }});
  table.add({"edit.import_keys", "Edit", translatable("Import keys\u2026"),
             translatable("Take the keys of a file in place of those that are in use."), "", "", false, false,
             [&workbench] { workbench.files().import_keys(); }});
}

}  // namespace hariko
