#include "ui/view/view_menus.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "ui/base/icons.hpp"
#include "ui/editor/saved_views.hpp"
#include "ui/view/snapping.hpp"
#include "ui/view/view_frame.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/inputs.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/number_slider.hpp"
#include "ui/widgets/option_fields.hpp"
#include "ui/widgets/overlay_window.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

constexpr float least_pane_for_views = 380;  ///< design pixels; narrower views have no room for it
constexpr float views_row_width = 250, views_list_rows = 12;

bool views_have_room(const PanelContext& context, const PanelRect& pane) {
  return pane.width() >= context.metrics.px(least_pane_for_views);
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
  if (selectable_row(context.marks, "views.go." + view.name, shown, here, {width - buttons, 0},
                     ImGuiSelectableFlags_DontClosePopups))
    deed = {ViewDeed::Kind::go, view.name};
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
    const std::string mark = "views." + std::string(one.id) + "." + view.name;
    if (icon_button(context, one.icon, mark, one.tip, false, button)) deed = {one.kind, view.name};
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
  if (views.empty()) return dim_text(context.tr("No view is saved yet."));
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
  plain_text(context.tr("Focal length"));
  ImGui::SameLine(context.metrics.px(118));
  const std::string format = "%.0f " + std::string(to_string(Unit::millimetre));
  const bool changed =
      number_slider(context.marks, "views.focal_length",
                    {SavedView::least_focal_length, SavedView::greatest_focal_length, format.c_str(),
                     ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic},
                    shown, context.metrics.px(views_row_width - 88));
  if (ImGui::IsItemActivated()) view.remember();
  if (ImGui::IsItemHovered())
    pointer_tip(context.tr("Millimetres, as on film of 36 x 24 mm; the model keeps its size in the view"));
  if (changed) view.set(view.goal().with_focal_length(shown));
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
  return view_menu_button(context, view, views_button_place(context, title, pane), "views");
}

void draw_views_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane,
                       bool hovered) {
  if (!views_have_room(context, pane)) return;
  const bool active = context.editor.layout.active() == view;
  const ImU32 colour = active || hovered ? palette().text : palette().dim_text;
  const OpenScope menu = view_menu(context, views_button_place(context, title, pane), context.tr("Views"),
                                   colour, "views." + std::to_string(view));
  if (!menu) return;
  context.editor.layout.activate(view);
  saved_view_list(context);
  draw_menu_items(context, {"", "view.save", ""}, "views.");
  lens_slider(context);
  draw_menu_items(context, {"view.two_point"}, "views.");
}

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

/// `label`: shorter than that of the command, as the menu says what it is about.
void snap_check(PanelContext& context, const char* id, const char* label) {
  const Command* command = context.commands.find(id);
  HARIKO_ASSERT(command && command->checked, "a switch of snapping");
  bool on = command->checked();
  const std::string mark = std::string("snaps.") + id;
  if (option_check(context, mark.c_str(), label, "", on)) context.run(id);
  if (ImGui::IsItemHovered()) command_tooltip(context, *command, std::nullopt, false);
}

}  // namespace

bool snap_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane) {
  if (!has_room(context, pane)) return false;
  return view_menu_button(context, view, button_place(context, title), "snaps");
}

void draw_snap_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane,
                      bool hovered) {
  if (!has_room(context, pane)) return;
  const bool active = context.editor.layout.active() == view;
  const ImU32 colour = context.editor.settings.snaps.always ? palette().accent
                       : active || hovered                  ? palette().text
                                                            : palette().dim_text;
  const OpenScope menu = view_menu(context, button_place(context, title), button_text(context).c_str(),
                                   colour, "snaps." + std::to_string(view));
  if (!menu) return;
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
  draw_menu_items(
      context,
      {"", "plane.ground", "plane.view", "plane.face", "plane.points", "plane.section", "plane.look"},
      "snaps.");
}

namespace {

Quantity focal_length_quantity() {
  Quantity quantity;
  quantity.unit = "mm";
  quantity.decimals = 1;
  quantity.step = 1;
  quantity.low = SavedView::least_focal_length;
  quantity.high = SavedView::greatest_focal_length;
  return quantity;
}

}  // namespace

void ask_view_name(Editor& editor, CommandServices& services, const std::string& name) {
  const Language& tr = editor.language;
  const auto typed = std::make_shared<std::string>(name);
  const auto first = std::make_shared<bool>(true);
  Prompt::Request request;
  request.title = tr("Rename view");
  request.text = tr("A name that no other saved view has.");
  request.fields = [typed, first](PanelContext& context) {
    if (*first) ImGui::SetKeyboardFocusHere();
    *first = false;
    text_field(context.marks, "view_name", *typed, context.metrics.px(280), "",
               ImGuiInputTextFlags_AutoSelectAll);
  };
  request.answers = {{tr("Rename"), "rename", [&editor, typed, name] { name_view(editor, name, *typed); }},
                     {tr("Cancel"), "cancel", {}}};
  services.ask(std::move(request));
}

void ask_focal_length(Editor& editor, CommandServices& services) {
  struct Field {
    double millimetres;
    std::string text = {};
  };
  const Language& tr = editor.language;
  const auto field =
      std::make_shared<Field>(Field{focal_length_of(editor.layout.active_view().goal().field_of_view)});
  const Quantity quantity = focal_length_quantity();
  Prompt::Request request;
  request.title = tr("Focal length");
  request.text = tr("15 to 300 mm, as on film of 36 x 24 mm. The model keeps its size in the view.");
  request.fields = [field, quantity](PanelContext& context) {
    option_label(context, "Focal length");
    option_field(context, "focal_length", "Short lenses see wide, long ones flatten", 140, quantity,
                 field->text, field->millimetres);
  };
  request.answers = {{tr("Set"), "set",
                      [&editor, field] {
                        View& view = editor.layout.active_view();
                        view.remember();
                        view.set(view.goal().with_focal_length(field->millimetres));
                      }},
                     {tr("Cancel"), "cancel", {}}};
  services.ask(std::move(request));
}

}  // namespace hariko
