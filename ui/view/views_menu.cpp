#include "ui/view/views_menu.hpp"

#include <array>
#include <optional>
#include <string>

#include "ui/base/icons.hpp"
#include "ui/editor/saved_views.hpp"
#include "ui/view/rename_view.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/overlay_window.hpp"

namespace hariko {

namespace {

constexpr float least_pane_for_views = 380;  ///< design pixels; narrower views have no room for it
constexpr float views_row_width = 250, views_list_rows = 12;

bool views_have_room(const PanelContext& context, const PanelRect& pane) {
  return pane.width() >= context.metrics.px(least_pane_for_views);
}

std::string views_popup_name(int view) {
  return "views." + std::to_string(view);
}

/// Change of a saved view, made after the list of views is drawn.
struct ViewDeed {
  enum class Kind { go, update, rename, erase } kind;
  std::string name;
};

/// A row: its name, which goes there, and buttons at the right.
std::optional<ViewDeed> saved_view_row(PanelContext& context, const SavedView& view) {
  const Metrics& m = context.metrics;
  const float button = 22, width = m.px(views_row_width), buttons = 3 * (m.px(button) + m.px(4));
  std::optional<ViewDeed> deed;
  ImGui::PushID(view.name.c_str());
  const bool here = looks_as(context.editor.layout.active_view().goal(), view);
  const std::string shown = elided(view.name, width - buttons - m.px(8));
  if (ImGui::Selectable((shown + "###go").c_str(), here, ImGuiSelectableFlags_DontClosePopups,
                        {width - buttons, 0}))
    deed = {ViewDeed::Kind::go, view.name};
  context.marks.item("views.go." + view.name);
  struct Button {
    ViewDeed::Kind kind;
    const char *icon, *id, *tip;
  };
  constexpr std::array all{Button{ViewDeed::Kind::update, icon::orbit, "update",
                                  translatable("Take over what the view shows now")},
                           Button{ViewDeed::Kind::rename, icon::keyboard, "rename", translatable("Rename")},
                           Button{ViewDeed::Kind::erase, icon::trash, "delete", translatable("Delete")}};
  for (const Button& one : all) {
    ImGui::SameLine(0, m.px(4));
    if (icon_button(context, one.icon, one.id, one.tip, false, button)) deed = {one.kind, view.name};
    context.marks.item("views." + std::string(one.id) + "." + view.name);
  }
  ImGui::PopID();
  return deed;
}

void do_with_view(PanelContext& context, const ViewDeed& deed) {
  Editor& editor = context.editor;
  switch (deed.kind) {
    case ViewDeed::Kind::go:
      go_to_view(editor, deed.name);
      break;
    case ViewDeed::Kind::update:
      take_over_view(editor, deed.name);
      break;
    case ViewDeed::Kind::rename:
      ImGui::CloseCurrentPopup();
      ask_view_name(editor, context.services, deed.name);
      break;
    case ViewDeed::Kind::erase:
      delete_view(editor, deed.name);
      break;
  }
}

void saved_view_list(PanelContext& context) {
  const SavedViews& views = *context.editor.document().saved_views;
  if (views.empty()) {
    ImGui::TextDisabled("%s", context.tr("No view is saved yet."));
    return;
  }
  const float line = ImGui::GetFrameHeightWithSpacing();
  const bool many = float(views.size()) > views_list_rows;
  std::optional<ViewDeed> deed;
  // A long list scrolls.
  if (many) ImGui::BeginChild("list", {context.metrics.px(views_row_width + 20), views_list_rows * line});
  for (const SavedView& view : views)
    if (auto wanted = saved_view_row(context, view)) deed = std::move(wanted);
  if (many) ImGui::EndChild();
  if (deed) do_with_view(context, *deed);
}

void lens_slider(PanelContext& context) {
  View& view = context.editor.layout.active_view();
  double shown = focal_length_of(view.goal().field_of_view);
  ImGui::TextUnformatted(context.tr("Focal length"));
  ImGui::SameLine(context.metrics.px(118));
  const std::string format = "%.0f " + std::string(to_string(Unit::millimetre));
  const bool changed =
      number_slider("###focal",
                    {SavedView::least_focal_length, SavedView::greatest_focal_length, format.c_str(),
                     ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic},
                    shown, context.metrics.px(views_row_width - 88));
  context.marks.item("views.focal_length");
  if (ImGui::IsItemActivated()) view.remember();
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(
        "%s", context.tr("Millimetres, as on film of 36 x 24 mm; the model keeps its size in the view"));
  if (changed) view.set(view.goal().with_focal_length(shown));
}

void views_command_row(PanelContext& context, const char* id) {
  const Command* command = context.commands.find(id);
  HARIKO_ASSERT(command, "a command on views");
  const auto reason = command->why_not ? command->why_not() : std::nullopt;
  const bool checked = command->checked && command->checked();
  if (ImGui::MenuItem(context.tr(command->label).c_str(), first_key(*command).c_str(), checked, !reason))
    context.commands.run(*command);
  context.marks.item(std::string("views.") + id);
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
    command_tooltip(context, *command, reason, false);
}

}  // namespace

PanelRect views_button_place(const PanelContext& context, const PanelRect& title, const PanelRect& pane) {
  if (!views_have_room(context, pane)) return title;
  const Metrics& m = context.metrics;
  const ImVec2 min(title.max.x + m.px(4), title.min.y);
  return {min, {min.x + ImGui::CalcTextSize(context.tr("Views")).x + m.px(30), title.max.y}};
}

bool views_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane) {
  if (!views_have_room(context, pane)) return false;
  const PanelRect place = views_button_place(context, title, pane);
  ImGui::SetCursorScreenPos(place.min);
  const std::string name = "views" + std::to_string(view);
  ImGui::InvisibleButton(name.c_str(), {place.width(), place.height()});
  context.marks.item("view." + std::to_string(view) + ".views");
  const bool hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemClicked(ImGuiMouseButton_Left)) {
    context.editor.layout.activate(view);
    ImGui::OpenPopup(views_popup_name(view).c_str());
  }
  return hovered;
}

void draw_views_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane,
                       bool hovered) {
  if (!views_have_room(context, pane)) return;
  const Metrics& m = context.metrics;
  const PanelRect place = views_button_place(context, title, pane);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(place.min, place.max, palette().overlay, m.px(4));
  const bool active = context.editor.layout.active() == view;
  const ImU32 colour = active || hovered ? palette().text : palette().dim_text;
  list.AddText({place.min.x + m.px(8), place.min.y + m.px(4)}, colour, context.tr("Views"));
  const ImVec2 tip(place.max.x - m.px(11), (place.min.y + place.max.y) / 2 + m.px(2));
  list.AddTriangleFilled({tip.x - m.px(3.5F), tip.y - m.px(4)}, {tip.x + m.px(3.5F), tip.y - m.px(4)}, tip,
                         colour);
  ImGui::SetNextWindowPos({place.min.x, place.max.y + m.px(2)});
  if (!ImGui::BeginPopup(views_popup_name(view).c_str())) return;
  context.editor.layout.activate(view);
  saved_view_list(context);
  ImGui::Separator();
  views_command_row(context, "view.save");
  ImGui::Separator();
  lens_slider(context);
  views_command_row(context, "view.two_point");
  ImGui::EndPopup();
}

}  // namespace hariko
