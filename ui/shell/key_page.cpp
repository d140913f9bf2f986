// The page of the preferences where keys are given to commands.

#include <imgui.h>

#include <algorithm>

#include "ui/base/fuzzy.hpp"
#include "ui/base/icons.hpp"
#include "ui/shell/preferences.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/inputs.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/overlay_window.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

void KeyPage::record(const Command& command, std::size_t slot) {
  recording_ = command.id;
  slot_ = slot;
  wanted_.reset();
}

bool KeyPage::key(Editor& editor, const CommandTable& commands, const KeyChord& chord) {
  if (recording_.empty()) return false;
  if (CommandTable::is_reserved(chord)) {
    recording_.clear();
    return true;
  }
  if (wanted_) {
    if (chord.key == Key::enter) assign(editor, commands);
    return true;
  }
  if (!chord.is_known()) return true;  // a modifier on its way to a chord
  wanted_ = chord;
  const Command* owner = commands.find(chord);
  if (!owner || owner->id == recording_) assign(editor, commands);
  return true;
}

void KeyPage::assign(Editor& editor, const CommandTable& commands) {
  auto keys = parse_keys(commands.find(recording_)->keys).value();
  if (std::find(keys.begin(), keys.end(), *wanted_) == keys.end()) {
    if (slot_ < keys.size())
      keys[slot_] = *wanted_;
    else
      keys.push_back(*wanted_);
    editor.settings.keys = commands.with_keys(editor.settings.keys, recording_, keys);
  }
  recording_.clear();
}

void KeyPage::draw(PanelContext& context) {
  const Metrics& m = context.metrics;
  const Language& tr = context.tr;
  const char* const import = tr("Import\u2026");
  const char* const export_ = tr("Export\u2026");
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto button_width = [&](const char* label) {
    return ImGui::CalcTextSize(label).x + 2 * style.FramePadding.x + style.ItemSpacing.x;
  };
  text_field(context.marks, "preferences.search", search_, -(button_width(import) + button_width(export_)),
             tr("Search by name or key"));
  ImGui::SameLine();
  if (text_button(context.marks, "preferences.keys.import", import)) context.run("edit.import_keys");
  ImGui::SameLine();
  if (text_button(context.marks, "preferences.keys.export", export_)) context.run("edit.export_keys");
  if (wanted_ && !recording_.empty()) draw_conflict(context);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(m.px(4), m.px(4)));
  if (ImGui::BeginChild("list", {0, 0}, false, ImGuiWindowFlags_NavFlattened)) {
    for (const std::string& menu : context.commands.menus()) {
      bool titled = false;
      for (const Command& command : context.commands.all()) {
        const auto folders = menu_folders(command.menu);
        if (folders.empty() || folders[0] != menu) continue;
        if (!search_.empty() && fuzzy_score(search_, tr(command.label)) <= 0 &&
            fuzzy_score(search_, command.label) <= 0 && fuzzy_score(search_, command.keys) <= 0)
          continue;
        if (!titled) heading(context, tr(menu.c_str()));
        titled = true;
        draw_row(context, command);
      }
    }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void KeyPage::draw_conflict(PanelContext& context) {
  const Language& tr = context.tr;
  const Command* owner = context.commands.find(*wanted_);
  const Command* command = context.commands.find(recording_);
  if (!owner || !command) return recording_.clear();
  coloured_lines(palette().warning,
                 fill(tr("{0} belongs to \u201c{1}\u201d. Give it to \u201c{2}\u201d instead?"),
                      {wanted_->to_string(), tr(owner->label), tr(command->label)}));
  context.marks.item("preferences.conflict");
  if (text_button(context.marks, "preferences.replace", tr("Replace")))
    assign(context.editor, context.commands);
  ImGui::SameLine();
  if (text_button(context.marks, "preferences.keep", tr("Cancel"))) recording_.clear();
}

void KeyPage::draw_row(PanelContext& context, const Command& command) {
  const Metrics& m = context.metrics;
  const Language& tr = context.tr;
  ImGui::PushID(command.id.c_str());
  const float keys_at = ImGui::GetContentRegionAvail().x * 0.5F;
  aligned_text(elided(tr(command.label), keys_at - m.px(8)));
  if (ImGui::IsItemHovered()) command_tooltip(context, command, {}, true);
  ImGui::SameLine(keys_at);
  auto keys = parse_keys(command.keys).value();
  const bool recording = recording_ == command.id && !wanted_;
  std::optional<std::size_t> removed;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const bool here = recording && slot_ == i;
    const std::string text = here ? tr("Press a key\u2026") : keys[i].to_string();
    if (text_button(context.marks, "preferences.key." + command.id + "." + std::to_string(i), text))
      record(command, i);
    if (ImGui::IsItemHovered()) show_tip(tr("Click and press another key. Right click removes this one."));
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) removed = i;
    ImGui::SameLine();
  }
  const std::string add = "preferences.add." + command.id;
  if (recording && slot_ >= keys.size())
    text_button(context.marks, add, tr("Press a key\u2026"));
  else if (icon_button(context, icon::add, add, tr("Add a key"), false, 26))
    record(command, keys.size());
  if (command.keys != command.default_keys) {
    ImGui::SameLine();
    const std::string text =
        fill(tr("Back to the default: {0}"),
             {command.default_keys.empty() ? std::string(tr("no key")) : command.default_keys});
    if (icon_button(context, icon::reset, "preferences.default." + command.id, text.c_str(), false, 26)) {
      const auto defaults = parse_keys(command.default_keys).value();
      context.editor.settings.keys =
          context.commands.with_keys(context.editor.settings.keys, command.id, defaults);
      recording_.clear();
    }
  }
  if (removed) {
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(*removed));
    context.editor.settings.keys = context.commands.with_keys(context.editor.settings.keys, command.id, keys);
    recording_.clear();
  }
  ImGui::PopID();
}

}  // namespace hariko
