// Commands that help to find things: the palette, the cheat sheet, preferences, the language, the guided
// first model, and what this program is.

#include <imgui.h>

#include "ui/base/fonts.hpp"
#include "ui/base/icons.hpp"
#include "ui/base/system_information.hpp"
#include "ui/editor/command_host.hpp"
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

MenuRows rows_of_help(CommandHost& host) {
  return {host.table, translatable("Help"), true};
}

void add_recording(CommandHost& host, Workbench& workbench) {
  Editor& editor = host.editor;
  MenuRows rows = rows_of_help(host);
  rows.add("help.record", translatable("Record a replay\u2026"),
           translatable("Write what you do from here on to a file that plays it again."),
           [&workbench] { workbench.files().record(); },
           only_if(
               needs_document(editor), [&editor] { return !editor.recording; },
               translatable("A replay is being recorded already.")),
           {.separator_before = true, .needs_window = true});
  rows.add("help.stop_recording", translatable("Stop recording"),
           translatable("End the replay that is being recorded."),
           [&host] { host.application.stop_recording(); },
           only_if([&editor] { return editor.recording; }, translatable("No replay is being recorded.")),
           {.needs_window = true});
}

}  // namespace

void add_help_commands(CommandHost& host, Workbench& workbench) {
  Editor& editor = host.editor;
  MenuRows rows = rows_of_help(host);
  rows.add("help.palette", translatable("Search commands\u2026"),
           translatable("Find any command or object by a few letters of its name."),
           [&workbench] { workbench.show_palette(); }, {},
           {.keys = "F3 / Ctrl+Shift+P", .icon = icon::search, .needs_window = true});
  rows.add("help.keys", translatable("Keys at a glance"),
           translatable("Show every key, those of the present tool first."),
           [&workbench] { workbench.show_cheat_sheet(); }, {},
           {.keys = "F1 / ?", .icon = icon::keyboard, .needs_window = true});
  rows.add("help.context_menu", translatable("Menu at the pointer"),
           translatable("What can be done with what is under the pointer."),
           [&workbench] { workbench.show_context_menu(); }, needs_document(editor),
           {.keys = "Menu / Shift+F10", .needs_window = true});
  add_recording(host, workbench);
  rows.add("help.log", translatable("Open the log folder"),
           translatable("Show the files that a report about a mistake of the program needs."),
           [&host] { host.application.show_log_folder(); }, {}, {.needs_window = true});
  rows.add("help.about", translatable("About Hariko"), translatable("Version, graphics driver and licences."),
           [&workbench, &editor] { show_about(workbench, editor.language); }, {},
           {.icon = icon::info, .separator_before = true, .needs_window = true});
}

void add_preferences_commands(CommandHost& host, Workbench& workbench) {
  MenuRows rows(host.table, translatable("Edit"));
  rows.add("edit.preferences", translatable("Preferences\u2026"),
           translatable("Language, theme, navigation, units, keys."),
           [&workbench] { workbench.show_preferences(); }, {},
           {.keys = "Ctrl+,", .icon = icon::settings, .separator_before = true, .needs_window = true});
  rows.add("edit.export_keys", translatable("Export keys\u2026"),
           translatable("Write the keys that are not the default ones to a file."),
           [&workbench] { workbench.files().export_keys(); }, {}, {.needs_window = true});
  rows.add("edit.import_keys", translatable("Import keys\u2026"),
           translatable("Take the keys of a file in place of those that are in use."),
           [&workbench] { workbench.files().import_keys(); }, {}, {.needs_window = true});
}

void add_language_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const auto language = [&](const std::string& id, const std::string& name, const std::string& english_name) {
    rows_of_help(host).add(
        "language." + id, name, "Show the program in this language.",
        [&editor, id] { editor.settings.language = id; },
        [name]() -> Reason {
          if (fonts_can_write(name)) return {};
          return no_japanese_font;
        },
        {.separator_before = id == english_id,
         .needs_window = true,
         .checked = [&editor, id] { return editor.settings.language == id; },
         .other_names = english_name});
  };
  language(english_id, "English", {});
  for (const LanguageFile& each : editor.languages) language(each.id, each.name, each.english_name);
}

namespace {

void start_guide(Editor& editor) {
  if (!editor.has_document) editor.open({}, {});
  editor.guide.start({editor.history.current(), editor.exports});
}

}  // namespace

void add_start_commands(CommandHost& host) {
  Editor& editor = host.editor;
  rows_of_help(host).add(
      "help.guide", "Your first model", "Make a model in two minutes, step by step.",
      [&editor] { start_guide(editor); }, {},
      {.icon = icon::info, .needs_window = true, .checked = [&editor] { return editor.guide.shown(); }});
}

}  // namespace hariko
