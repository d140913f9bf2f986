// The menu bar: the command table by menus, and the name of the document. Where the window is narrow the
// field becomes a button, and menus that still have no room go into one at the end.

#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

#include "ui/base/icons.hpp"
#include "ui/base/key_chord.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/overlay_window.hpp"

namespace hariko {

namespace {

constexpr float whole_field = 170, field_button = 32, field_margin = 10;  ///< points
constexpr float title_gap = 12, least_title = 64;                         ///< points
constexpr const char* more_menu = "\u00bb";

std::string menu_label(const PanelContext& context, const std::string& menu) {
  return context.tr(menu) + "###" + menu;
}

float menu_width(const std::string& name) {
  return ImGui::CalcTextSize(name.c_str()).x + 2 * ImGui::GetStyle().ItemSpacing.x;
}

struct MenuBarFit {
  std::size_t menus = 0;  ///< number that stands in the bar; the others go into the last one
  bool whole_field = false;
};

/// The field gives way to the name of the document, which is `title` wide.
MenuBarFit fit_menu_bar(const PanelContext& context, const std::vector<std::string>& menus, float title) {
  const Metrics& m = context.metrics;
  const auto room = [&](float field) {
    return ImGui::GetWindowWidth() - ImGui::GetCursorPosX() - m.px(field + 2 * field_margin);
  };
  const auto taken = [&](std::size_t count) {
    return std::accumulate(
        menus.begin(), menus.begin() + std::ptrdiff_t(count), 0.0F,
        [&](float sum, const std::string& menu) { return sum + menu_width(context.tr(menu)); });
  };
  const float named = title > 0 ? title + m.px(2 * title_gap) : 0;
  if (taken(menus.size()) + named <= room(whole_field)) return {menus.size(), true};
  if (taken(menus.size()) <= room(field_button)) return {menus.size(), false};
  std::size_t count = menus.size();
  while (count > 0 && taken(count) + menu_width(more_menu) > room(field_button)) count--;
  return {count, false};
}

/// The letter that opens a menu, while letters are shown: underlined in its name, or on a small plate beside
/// a name in other letters. With Alt alone those are left out that commands have.
void draw_letter(const PanelContext& context, const std::string& menu, ImDrawList& bar, ImVec2 at) {
  using MenuLetters = PanelState::MenuLetters;
  const MenuLetters how = context.state.menu_letters;
  if (how == MenuLetters::hidden) return;
  const std::vector<std::string> menus = context.commands.menus();
  const auto number = static_cast<std::size_t>(std::find(menus.begin(), menus.end(), menu) - menus.begin());
  const char letter = menu_letters(menus)[number];
  if (letter == 0) return;
  if (how == MenuLetters::with_alt && context.commands.find(KeyChord{Key{letter}, false, false, true}))
    return;
  const std::string name = context.tr(menu);
  const float height = ImGui::GetTextLineHeight(), line = context.metrics.px(2);
  const auto place = std::ranges::find_if(
      name, [letter](char c) { return std::toupper(static_cast<unsigned char>(c)) == letter; });
  if (place != name.end()) {
    const std::string before(name.begin(), place), own(1, *place);
    const float left = at.x + ImGui::CalcTextSize(before.c_str()).x, bottom = at.y + height;
    bar.AddLine({left, bottom}, {left + ImGui::CalcTextSize(own.c_str()).x, bottom}, palette().accent, line);
    return;
  }
  const std::string own(1, letter);
  const ImVec2 size = ImGui::CalcTextSize(own.c_str());
  const ImVec2 low(at.x + ImGui::CalcTextSize(name.c_str()).x - size.x / 2, at.y + height / 3);
  bar.AddRectFilled({low.x - line, low.y}, {low.x + size.x + line, low.y + size.y}, palette().accent, line);
  bar.AddText(low, palette().on_accent, own.c_str());
}

void draw_menu(PanelContext& context, const std::string& menu) {
  const std::string label = menu_label(context, menu);
  if (context.state.wanted_menu == menu) {
    context.state.wanted_menu.clear();
    ImGui::OpenPopup(label.c_str());
  }
  ImVec2 at = ImGui::GetCursorScreenPos();
  at.y += GImGui->CurrentWindow->DC.CurrLineTextBaseOffset;
  ImDrawList& bar = *ImGui::GetWindowDrawList();
  const OpenScope opened = menu_scope(context.marks, "menu." + menu, label);
  draw_letter(context, menu, bar, {at.x + ImGui::GetStyle().ItemSpacing.x / 2, at.y});
  if (!opened) return;
  context.state.menu_open = true;
  draw_menu_nodes(context, menu_tree(context.commands, menu), "command.");
}

/// The way to the palette for those who do not know its key; looks like a field. Gives its left end.
float search_field(PanelContext& context, bool whole) {
  const Metrics& m = context.metrics;
  const Command& search = *context.commands.find("help.palette");
  const std::string text = whole ? std::string(icon::search) + "  " + context.tr("Search") : icon::search;
  const std::string key = whole ? first_key(search) : "";
  const ImVec2 size(m.px(whole ? whole_field : field_button), ImGui::GetTextLineHeight() + m.px(6));
  const float left = ImGui::GetWindowWidth() - size.x - m.px(field_margin);
  ImGui::SetCursorPosX(left);
  const ImVec2 at(ImGui::GetCursorScreenPos().x, (ImGui::GetWindowHeight() - size.y) / 2);
  ImGui::SetCursorScreenPos(at);
  const bool pressed = area_button(context.marks, "menu.search", size);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) command_tooltip(context, search, {}, true);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(at, {at.x + size.x, at.y + size.y}, hovered ? palette().field_hover : palette().field,
                     m.px(4));
  draw.AddText({at.x + m.px(8), at.y + m.px(3)}, palette().dim_text, text.c_str());
  draw.AddText({at.x + size.x - ImGui::CalcTextSize(key.c_str()).x - m.px(8), at.y + m.px(3)},
               palette().dim_text, key.c_str());
  if (pressed) context.run(search.id);
  return left;
}

/// "mouse.hariko  •  edited"; empty without a document.
std::string title_of_document(const PanelContext& context) {
  const Editor& editor = context.editor;
  if (!editor.has_document) return {};
  std::string title = editor.title();
  if (editor.read_only) title += std::string("  \u2022  ") + context.tr("read-only");
  if (editor.history.dirty()) title += std::string("  \u2022  ") + context.tr("edited");
  return title;
}

/// Between the menus and the field, as far as there is room; the window's own title has it whole.
void draw_title(PanelContext& context, const std::string& title, float menus_end, float field) {
  const float gap = context.metrics.px(title_gap), room = field - menus_end - 2 * gap;
  const float whole = ImGui::CalcTextSize(title.c_str()).x;
  if (title.empty() || room < std::min(whole, context.metrics.px(least_title))) return;
  const std::string shown = elided(title, room);
  const ImVec2 size = ImGui::CalcTextSize(shown.c_str()), corner = ImGui::GetWindowPos();
  const ImVec2 at(corner.x + field - size.x - gap, corner.y + (ImGui::GetWindowHeight() - size.y) / 2);
  ImGui::GetWindowDrawList()->AddText(at, palette().dim_text, shown.c_str());
  context.marks.rect("menu.title", at, {at.x + size.x, at.y + size.y});
}

}  // namespace

float draw_menu_bar(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.metrics.px(10), context.metrics.px(6)));
  const bool open = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar();
  if (!open) return 0;
  const std::vector<std::string> menus = context.commands.menus();
  context.state.menu_letters = std::exchange(context.state.menu_open, false) ? PanelState::MenuLetters::alone
                               : ImGui::GetIO().KeyAlt ? PanelState::MenuLetters::with_alt
                                                       : PanelState::MenuLetters::hidden;
  const std::string title = title_of_document(context);
  const MenuBarFit fit = fit_menu_bar(context, menus, ImGui::CalcTextSize(title.c_str()).x);
  for (std::size_t i = 0; i < fit.menus; i++) draw_menu(context, menus[i]);
  if (fit.menus < menus.size()) {
    const OpenScope more = menu_scope(context.marks, "menu.more", more_menu);
    for (std::size_t i = fit.menus; more && i < menus.size(); i++) draw_menu(context, menus[i]);
  }
  const float used = ImGui::GetCursorPosX();
  const float field = search_field(context, fit.whole_field);
  draw_title(context, title, used, field);
  const float height = ImGui::GetWindowHeight();
  ImGui::EndMainMenuBar();
  return height;
}

}  // namespace hariko
