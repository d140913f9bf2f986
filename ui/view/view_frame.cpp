#include "ui/view/view_frame.hpp"

#include <cmath>

#include "render/color_map.hpp"
#include "render/grid_plane.hpp"
#include "ui/base/icons.hpp"
#include "ui/view/overlay_drawing.hpp"
#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/items.hpp"

namespace hariko {

namespace {

std::string popup_name(int view) {
  return "view menu " + std::to_string(view);
}

void draw_menu(PanelContext& context) {
  draw_menu_items(context,
                  {"view.iso", "view.front", "view.back", "view.right", "view.left", "view.top",
                   "view.bottom", "", "view.orthographic", "view.two_point", "view.lock", "view.frame_all",
                   "view.frame_selection", "", "view.maximise", "view.two", "view.four"},
                  "title.");
}

}  // namespace

bool view_menu_button(PanelContext& context, int view, const PanelRect& place, const std::string& kind) {
  const std::string number = std::to_string(view);
  const bool hovered = pointer_area(context.marks, "view." + number + "." + kind, place);
  if (ImGui::IsItemClicked(ImGuiMouseButton_Left)) {
    context.editor.layout.activate(view);
    ImGui::OpenPopup((kind + "." + number).c_str());
  }
  return hovered;
}

OpenScope view_menu(const PanelContext& context, const PanelRect& place, const char* text, ImU32 colour,
                    const std::string& popup) {
  const Metrics& m = context.metrics;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(place.min, place.max, palette().overlay, m.px(4));
  list.AddText({place.min.x + m.px(8), place.min.y + m.px(4)}, colour, text);
  // A small triangle says that there is a menu.
  const ImVec2 tip(place.max.x - m.px(11), (place.min.y + place.max.y) / 2 + m.px(2));
  list.AddTriangleFilled({tip.x - m.px(3.5F), tip.y - m.px(4)}, {tip.x + m.px(3.5F), tip.y - m.px(4)}, tip,
                         colour);
  ImGui::SetNextWindowPos({place.min.x, place.max.y + m.px(2)});
  return popup_scope(popup);
}

const char* title_of(const Camera& camera) {
  const auto side = side_of(camera);
  if (!side || !camera.orthographic)
    return camera.orthographic ? translatable("Orthographic")
           : camera.two_point  ? translatable("Two-point")
                               : translatable("Perspective");
  switch (*side) {
    case StandardView::front:
      return translatable("Front");
    case StandardView::back:
      return translatable("Back");
    case StandardView::left:
      return translatable("Left");
    case StandardView::right:
      return translatable("Right");
    case StandardView::top:
      return translatable("Top");
    default:
      return translatable("Bottom");
  }
}

PanelRect view_title_place(const PanelContext& context, int view, const PanelRect& pane) {
  const Metrics& m = context.metrics;
  const View& shown = context.editor.layout.views[static_cast<std::size_t>(view)];
  const ImVec2 text = ImGui::CalcTextSize(context.tr(title_of(shown.goal())));
  const ImVec2 min(pane.min.x + m.px(8), pane.min.y + m.px(8));
  return {min, {min.x + text.x + m.px(30), min.y + text.y + m.px(8)}};
}

bool view_title_button(PanelContext& context, int view, const PanelRect& pane) {
  const PanelRect place = view_title_place(context, view, pane);
  const bool hovered = pointer_area(context.marks, "view." + std::to_string(view) + ".title", place);
  ViewLayout& layout = context.editor.layout;
  // The first click of a double click opened the menu, which now keeps the pointer from items below it.
  const bool reached = hovered || ImGui::IsPopupOpen(popup_name(view).c_str());
  if (reached && ImGui::IsMouseHoveringRect(place.min, place.max, false) &&
      ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    layout.activate(view);
    layout.toggle_maximised();
  } else if (ImGui::IsItemClicked(ImGuiMouseButton_Left)) {
    layout.activate(view);
    ImGui::OpenPopup(popup_name(view).c_str());
  }
  return hovered;
}

void draw_view_title(PanelContext& context, int view, const PanelRect& pane, bool hovered) {
  const View& shown = context.editor.layout.views[static_cast<std::size_t>(view)];
  const bool active = context.editor.layout.active() == view;
  const ImU32 colour = active || hovered ? palette().text : palette().dim_text;
  const OpenScope menu = view_menu(context, view_title_place(context, view, pane),
                                   context.tr(title_of(shown.goal())), colour, popup_name(view));
  if (!menu) return;
  context.editor.layout.activate(view);
  draw_menu(context);
}

double scale_bar_length(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= longest) return digit * power;
  return power;
}

void draw_grid_labels(const PanelContext& context, const Camera& camera, const PanelRect& pane,
                      const GridSettings& grid) {
  const Metrics& m = context.metrics;
  const PixelSize size{std::max(1, static_cast<int>(pane.width())),
                       std::max(1, static_cast<int>(pane.height()))};
  int decimals = 0;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeight();
  for (const GridLabel& label : grid_labels(camera, size, grid, double(m.px(64)), decimals)) {
    const std::string text = fixed_text(label.value, decimals);
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    const auto along = static_cast<float>(label.pixel);
    const ImVec2 at = label.upright ? ImVec2(pane.min.x + along + m.px(3), pane.max.y - line - m.px(2))
                                    : ImVec2(pane.min.x + m.px(4), pane.min.y + along - line - m.px(1));
    // The title, the corner that both borders share, and the scale bar keep their places.
    const bool free = label.upright ? at.x > pane.min.x + m.px(48) && at.x + extent.x < pane.max.x - m.px(150)
                                    : at.y > pane.min.y + m.px(40) && at.y < pane.max.y - m.px(28);
    if (!free) continue;
    list.AddText({at.x + m.px(1), at.y + m.px(1)}, with_alpha(palette().window, 0.7F), text.c_str());
    list.AddText(at, palette().dim_text, text.c_str());
    context.marks.rect(std::string("grid.") + (label.upright ? "across." : "up.") + text, at,
                       {at.x + extent.x, at.y + extent.y});
  }
}

void draw_scale_bar(const PanelContext& context, const Camera& camera, const PanelRect& pane) {
  const Metrics& m = context.metrics;
  const double pixel = camera.view_height() / double(pane.height());  // a window pixel's length
  if (!(pixel > 0) || pane.width() < m.px(200)) return;
  const double length = scale_bar_length(pixel * double(m.px(110)));
  const auto width = static_cast<float>(length / pixel);
  const std::string text =
      format_number(length, 3) + " " + std::string(to_string(context.editor.document().unit));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(std::floor(pane.max.x - m.px(14)) + 0.5F, std::floor(pane.max.y - m.px(14)) + 0.5F);
  const float begin = std::floor(end.x - width) + 0.5F, tick = m.px(4);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at((begin + end.x - size.x) / 2, end.y - size.y - m.px(5));
  const auto bar = [&](ImVec2 by, ImU32 colour, float thick) {
    const auto line = [&](float x0, float y0, float x1, float y1) {
      list.AddLine({x0 + by.x, y0 + by.y}, {x1 + by.x, y1 + by.y}, colour, thick);
    };
    line(begin, end.y, end.x, end.y);
    line(begin, end.y - tick, begin, end.y + 0.5F);
    line(end.x, end.y - tick, end.x, end.y + 0.5F);
    list.AddText({at.x + by.x, at.y + by.y}, colour, text.c_str());
  };
  // A shadow keeps it readable on every surface.
  bar({m.px(1), m.px(1)}, with_alpha(palette().window, 0.6F), m.px(1.5F));
  bar({0, 0}, palette().text, m.px(1.5F));
}

}  // namespace hariko
