// Commands that choose the language of the interface.

#include "ui/base/fonts.hpp"
#include "ui/editor/command_host.hpp"

namespace hariko {

void add_language_commands(CommandHost& host) {
  Editor& editor = host.editor;
  const auto language = [&](const char* id, const char* label, LanguageId value, bool first,
                            const WhyNot& why_not) {
    host.table.add({.id = id,
                    .menu = "Help",
                    .label = label,
                    .help = "Show the program in this language.",
                    .separator_before = first,
                    .while_tool_runs = true,
                    .needs_window = true,
                    .run = [&editor, value] { editor.settings.language = value; },
                    .why_not = why_not,
                    .checked = [&editor, value] { return editor.settings.language == value; }});
  };
  language("help.english", "English", LanguageId::english, true, {});
  language("help.japanese", japanese_in_japanese, LanguageId::japanese, false, []() -> Reason {
    if (japanese_font_installed()) return {};
    return no_japanese_font;
  });
}

}  // namespace hariko
