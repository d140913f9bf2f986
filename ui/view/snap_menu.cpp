#include "ui/view/snap_menu.hpp"

#include <array>
#include <string>
#include <utility>

#include "ui/view/snapping.hpp"
#include "ui/widgets/command_menu.hpp"

namespace hariko {

namespace {

constexpr float least_pane_width = 300;  ///< design pixels; narrower views have no room beside the title

bool has_room(const PanelContext& context, const PanelRect& pane) {
  return pane.width() >= context.metrics.px(least_pane_width);
}

/// "Snaps", with the working plane where that is not the ground.
std::string button_text(const PanelContext& context) {
  const WorkingPlane& plane = context.editor.working_plane;
  std::string text = context.tr("Snaps");
  if (!plane.is_ground()) text += "   " + std::string(context.tr(plane_name(plane.kind)));
  return text;
}

PanelRect button_place(const PanelContext& context, const PanelRect& title) {
  const Metrics& m = context.metrics;
  const ImVec2 min(title.max.x + m.px(4), title.min.y);
  const float width = ImGui::CalcTextSize(button_text(context).c_str()).x + m.px(30);
  return {min, {min.x + width, title.max.y}};
}

std::string snap_popup_name(int view) {
  return "snaps." + std::to_string(view);
}

/// `label`: shorter than that of the command, as the menu says what it is about.
void snap_check(PanelContext& context, const char* id, const char* label) {
  const Command* command = context.commands.find(id);
  HARIKO_ASSERT(command && command->checked, "a switch of snapping");
  bool on = command->checked();
  if (ImGui::Checkbox((std::string(context.tr(label)) + "###" + id).c_str(), &on)) context.run(id);
  context.marks.item(std::string("snaps.") + id);
  if (ImGui::IsItemHovered()) command_tooltip(context, *command, std::nullopt, false);
}

void plane_row(PanelContext& context, const char* id) {
  const Command* command = context.commands.find(id);
  HARIKO_ASSERT(command, "a command of the working plane");
  const auto reason = command->why_not ? command->why_not() : std::nullopt;
  const bool checked = command->checked && command->checked();
  if (ImGui::MenuItem(context.tr(command->label).c_str(), first_key(*command).c_str(), checked, !reason))
    context.commands.run(*command);
  context.marks.item(std::string("snaps.") + id);
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
    command_tooltip(context, *command, reason, false);
}

}  // namespace

bool snap_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane) {
  if (!has_room(context, pane)) return false;
  const PanelRect place = button_place(context, title);
  ImGui::SetCursorScreenPos(place.min);
  const std::string name = "snaps" + std::to_string(view);
  ImGui::InvisibleButton(name.c_str(), {place.width(), place.height()});
  context.marks.item("view." + std::to_string(view) + ".snaps");
  const bool hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemClicked(ImGuiMouseButton_Left)) {
    context.editor.layout.activate(view);
    ImGui::OpenPopup(snap_popup_name(view).c_str());
  }
  return hovered;
}

void draw_snap_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane,
                      bool hovered) {
  if (!has_room(context, pane)) return;
  const Metrics& m = context.metrics;
  const PanelRect place = button_place(context, title);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(place.min, place.max, palette().overlay, m.px(4));
  const bool active = context.editor.layout.active() == view;
  const ImU32 colour = context.editor.settings.snaps.always ? palette().accent
                       : active || hovered                  ? palette().text
                                                            : palette().dim_text;
  list.AddText({place.min.x + m.px(8), place.min.y + m.px(4)}, colour, button_text(context).c_str());
  const ImVec2 tip(place.max.x - m.px(11), (place.min.y + place.max.y) / 2 + m.px(2));
  list.AddTriangleFilled({tip.x - m.px(3.5F), tip.y - m.px(4)}, {tip.x + m.px(3.5F), tip.y - m.px(4)}, tip,
                         colour);
  ImGui::SetNextWindowPos({place.min.x, place.max.y + m.px(2)});
  if (!ImGui::BeginPopup(snap_popup_name(view).c_str())) return;
  constexpr std::array<std::pair<const char*, const char*>, 9> kinds{
      {{"snap.vertices", translatable("Vertices")},
       {"snap.midpoints", translatable("Midpoints")},
       {"snap.centres", translatable("Centres")},
       {"snap.intersections", translatable("Intersections")},
       {"snap.perpendicular", translatable("Perpendicular")},
       {"snap.tangent", translatable("Tangent")},
       {"snap.curves", translatable("On curves")},
       {"snap.surfaces", translatable("On surfaces")},
       {"snap.grid", translatable("Grid")}}};
  for (const auto& [id, label] : kinds) snap_check(context, id, label);
  ImGui::Separator();
  snap_check(context, "snap.always", translatable("Snap without Ctrl"));
  ImGui::Separator();
  constexpr std::array planes{"plane.ground", "plane.view",    "plane.face",
                              "plane.points", "plane.section", "plane.look"};
  for (const char* id : planes) plane_row(context, id);
  ImGui::EndPopup();
}

}  // namespace hariko
