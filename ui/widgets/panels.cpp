#include "ui/widgets/panels.hpp"

#include <imgui_internal.h>

#include <utility>

#include "ui/base/icons.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

void PanelContext::run(std::string_view id) {
  const auto outcome = commands.run(id);
  if (!outcome.ran) editor.inform(outcome.reason);
}

void focus_next_field() {
  ImGui::SetWindowFocus();
  ImGui::SetKeyboardFocusHere();
}

bool begin_panel(const char* name, const PanelRect& rect, ImU32 background, ImVec2 padding,
                 ImGuiWindowFlags extra) {
  ImGui::SetNextWindowPos(rect.min);
  ImGui::SetNextWindowSize({rect.width(), rect.height()});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
  const bool open =
      ImGui::Begin(name, nullptr,
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoTitleBar |
                       ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                       ImGuiWindowFlags_NoSavedSettings | extra);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  return open;
}

bool main_button(Marks& marks, const std::string& mark, const std::string& text, float width) {
  ImGui::PushStyleColor(ImGuiCol_Button, palette().accent);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette().accent_hover);
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, palette().accent_hover);
  ImGui::PushStyleColor(ImGuiCol_Text, palette().on_accent);
  const bool pressed = text_button(marks, mark, text, width);
  ImGui::PopStyleColor(4);
  return pressed;
}

bool area_button(Marks& marks, const std::string& mark, ImVec2 size) {
  const bool pressed = ImGui::InvisibleButton(mark.c_str(), size);
  marks.item(mark);
  // Commands that cannot run now are pale; the ring round them is not.
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);
  ImGui::RenderNavHighlight({ImGui::GetItemRectMin(), ImGui::GetItemRectMax()}, ImGui::GetItemID());
  ImGui::PopStyleVar();
  return pressed;
}

bool pointer_button(Marks& marks, const std::string& mark, ImVec2 size) {
  // Tab counts every item while it looks for the next one, whatever its flags are.
  const bool looking = std::exchange(GImGui->NavMoveScoringItems, false);
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
  const bool pressed = ImGui::InvisibleButton(mark.c_str(), size);
  marks.item(mark);
  ImGui::PopItemFlag();
  GImGui->NavMoveScoringItems = looking;
  return pressed;
}

Disabled::Disabled(bool disabled) : disabled_(disabled), looking_(GImGui->NavMoveScoringItems) {
  ImGui::BeginDisabled(disabled);
  if (disabled_ && looking_) GImGui->NavMoveScoringItems = false;
}

Disabled::~Disabled() {
  if (disabled_ && looking_) GImGui->NavMoveScoringItems = true;
  ImGui::EndDisabled();
}

void show_keyboard_focus() {
  // Without the flag the next frame begins with taking the ring away.
  ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  GImGui->NavDisableHighlight = false;
  GImGui->NavDisableMouseHover = true;
}

void heading(const PanelContext& context, const char* text) {
  ImGui::Dummy({0, context.metrics.px(2)});
  dim_text(context.tr(text));
}

bool folding_heading(PanelContext& context, const std::string& id, const char* text,
                     ImGuiTreeNodeFlags extra) {
  constexpr ImGuiTreeNodeFlags flags =
      ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen;
  const bool open = ImGui::TreeNodeEx(("##" + id).c_str(), flags | extra, "%s", context.tr(text));
  context.marks.item("section." + id);
  return open;
}

bool icon_button(const PanelContext& context, const char* icon, const std::string& mark, const char* tooltip,
                 bool on, float size) {
  const ImVec2 box(context.metrics.px(size), context.metrics.px(size));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = area_button(context.marks, mark, box);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + box.x, at.y + box.y);
  if (on || hovered)
    draw.AddRectFilled(at, end,
                       on ? (palette().accent & 0x00ffffff) | (0x40u << IM_COL32_A_SHIFT) : palette().field,
                       context.metrics.px(4));
  const ImVec2 text = ImGui::CalcTextSize(icon);
  draw.AddText({at.x + (box.x - text.x) / 2, at.y + (box.y - text.y) / 2},
               on        ? palette().accent
               : hovered ? palette().text
                         : palette().dim_text,
               icon);
  if (hovered && *tooltip) show_tip(context.tr(tooltip));
  return pressed;
}

}  // namespace hariko
