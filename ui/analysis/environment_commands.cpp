// Commands that choose the environment which shaded surfaces reflect.

#include <string>

#include "ui/editor/command_host.hpp"
#include "ui/widgets/command_services.hpp"
#include "ui/widgets/enum_labels.hpp"

namespace hariko {

namespace {

std::string environment_menu() {
  return submenu("View", translatable("Environment"));
}

bool shows_environment(const Editor& editor, EnvironmentKind kind) {
  return editor.view.environment && !editor.view.map.map && editor.settings.environment.kind == kind;
}

void add_made_environments(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot document = needs_document(editor);
  for (const EnvironmentKind kind : enum_values<EnvironmentKind>()) {
    if (kind == EnvironmentKind::file) continue;
    host.table.add({.id = "environment." + std::string(enum_word(kind)),
                    .menu = environment_menu(),
                    .label = enum_choice(kind).label,
                    .help = "Let shaded surfaces reflect this environment.",
                    .while_tool_runs = true,
                    .run = [&editor, kind] { editor.show_environment(kind); },
                    .why_not = document,
                    .checked = [&editor, kind] { return shows_environment(editor, kind); }});
  }
}

/// Turns by a step; whole turns come back to the same number.
void turn_environment(Editor& editor, double degrees) {
  double& turn = editor.settings.environment.turn;
  turn += degrees;
  if (turn >= 360) turn -= 360;
  if (turn < 0) turn += 360;
}

void add_environment_turns(CommandHost& host) {
  Editor& editor = host.editor;
  const WhyNot shown =
      only_if([&editor] { return editor.view.environment; },
              translatable("No environment is shown. Choose Environment in the menu Analyse first."));
  const auto add = [&](const char* id, const char* label, const char* help, double degrees, bool first) {
    host.table.add({.id = id,
                    .menu = environment_menu(),
                    .label = label,
                    .help = help,
                    .separator_before = first,
                    .while_tool_runs = true,
                    .run = [&editor, degrees] { turn_environment(editor, degrees); },
                    .why_not = shown});
  };
  constexpr double step = 15;
  add("environment.turn_left", "Turn to the left",
      "Turn the environment by 15 degrees, clockwise from above.", -step, true);
  add("environment.turn_right", "Turn to the right",
      "Turn the environment by 15 degrees, anticlockwise from above.", step, false);
}

}  // namespace

void add_environment_commands(CommandHost& host) {
  Editor& editor = host.editor;
  CommandServices& services = host.services;
  add_made_environments(host);
  host.table.add({.id = "environment.file",
                  .menu = environment_menu(),
                  .label = "Picture file\u2026",
                  .help = "Let shaded surfaces reflect a panorama: a Radiance, PNG or JPEG picture twice as "
                          "wide as high.",
                  .while_tool_runs = true,
                  .needs_window = true,
                  .run = [&services] { services.choose_environment(); },
                  .why_not = needs_document(editor),
                  .checked = [&editor] { return shows_environment(editor, EnvironmentKind::file); }});
  add_environment_turns(host);
}

}  // namespace hariko
