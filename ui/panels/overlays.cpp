// What lies over the viewport: the legend of a map, and notices.

#include <algorithm>
#include <cmath>

#include "ui/icons.hpp"
#include "ui/panels/panels.hpp"

namespace hariko {

namespace {

ImU32 colour_at_fraction(SurfaceMap map, double x) {
  const Color c = color_at(scale_of(map), x);
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
}

}  // namespace

void draw_legend(PanelContext& context, const PanelRect& viewport) {
  const Object* object = context.editor.active_object();
  const SurfaceView* view = object ? context.editor.view_of(object->id) : nullptr;
  if (!view || !view->mesh || !object->visible || !has_values(object->display.map)) return;
  if (view->object->display.map != object->display.map) return;
  const SurfaceMap map = object->display.map;
  const Metrics& m = context.metrics;
  const float bar_width = m.px(14), bar_height = m.px(150), histogram_width = m.px(36);
  const ImVec2 low(viewport.min.x + m.px(16), viewport.max.y - m.px(16) - bar_height);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  constexpr int parts = 64;
  const auto y_of = [&](double fraction) { return low.y + bar_height * static_cast<float>(1 - fraction); };
  std::string title = context.tr(std::string(title_of(map)));
  const std::string unit = unit_of(map, to_string(context.editor.document().unit));
  if (!unit.empty()) title += "  " + unit;
  const ImVec2 title_size = ImGui::CalcTextSize(title.c_str());
  const ImVec2 box_low(low.x - m.px(8), low.y - title_size.y - m.px(16));
  const float box_right = low.x + std::max(title_size.x + m.px(8), m.px(130));
  draw.AddRectFilled(box_low, {box_right, viewport.max.y - m.px(4)}, palette().overlay, m.px(6));
  draw.AddText({low.x, box_low.y + m.px(6)}, palette().text, title.c_str());
  for (int i = 0; i < parts; ++i) {
    const double a = double(i) / parts, b = double(i + 1) / parts;
    draw.AddRectFilledMultiColor({low.x, y_of(b)}, {low.x + bar_width, y_of(a)}, colour_at_fraction(map, b),
                                 colour_at_fraction(map, b), colour_at_fraction(map, a),
                                 colour_at_fraction(map, a));
  }
  const std::size_t bins = view->histogram.size();
  for (std::size_t i = 0; i < bins; ++i)
    draw.AddRectFilled(
        {low.x + bar_width + m.px(4), y_of(double(i + 1) / double(bins))},
        {low.x + bar_width + m.px(4) + view->histogram[i] * histogram_width, y_of(double(i) / double(bins))},
        with_alpha(palette().text, 0.3F));
  for (const Tick& tick : legend_ticks(view->range)) {
    const float y = y_of(tick.fraction);
    draw.AddLine({low.x + bar_width - m.px(4), y}, {low.x + bar_width, y}, IM_COL32(0, 0, 0, 160));
    draw.AddText({low.x + bar_width + histogram_width + m.px(12), y - title_size.y / 2}, palette().text,
                 tick.label.c_str());
  }
}

void draw_notices(PanelContext& context, const PanelRect& viewport) {
  Editor& editor = context.editor;
  const Metrics& m = context.metrics;
  std::erase_if(editor.notices(), [&](const Notice& notice) {
    return notice.kind == Notice::Kind::info && editor.now - notice.shown_at > Notice::info_seconds;
  });
  float y = viewport.min.y + m.px(12);
  int dismissed = -1, number = 0;
  for (const Notice& notice : editor.notices()) {
    const float width = std::min(m.px(520), viewport.width() - m.px(24));
    ImGui::SetNextWindowPos({viewport.min.x + (viewport.width() - width) / 2, y});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, m.px(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(m.px(12), m.px(8)));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().popup);
    ImGui::Begin(("##notice" + std::to_string(number)).c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    const bool error = notice.kind == Notice::Kind::error, info = notice.kind == Notice::Kind::info;
    ImGui::PushStyleColor(ImGuiCol_Text, error  ? palette().error
                                         : info ? palette().secondary
                                                : palette().warning);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(error ? icon::error : info ? icon::info : icon::warning);
    ImGui::PopStyleColor();
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(width - m.px(48));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(notice.text.c_str());
    if (!notice.remedy.empty()) ImGui::TextDisabled("%s", notice.remedy.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    ImGui::SameLine(width - m.px(36));
    if (icon_button(context, icon::close, "dismiss", context.tr("Dismiss"), false, 24)) dismissed = number;
    context.marks.item("notice." + std::to_string(number));
    y += ImGui::GetWindowHeight() + m.px(8);
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    ++number;
  }
  if (dismissed >= 0) editor.notices().erase(editor.notices().begin() + dismissed);
}

void draw_cursor_note(PanelContext& context) {
  auto& note = context.editor.cursor_note;
  if (note && context.editor.now - note->shown_at > CursorNote::seconds) note.reset();
  if (!note) return;
  const Metrics& m = context.metrics;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float pad = m.px(8), wrap = m.px(300);
  const ImVec2 text = ImGui::CalcTextSize(note->text.c_str(), nullptr, false, wrap);
  const ImVec2 size(text.x + 2 * pad, text.y + 2 * pad);
  const ImVec2 low(std::clamp(note->x + m.px(14), 0.0F, std::max(0.0F, screen.x - size.x)),
                   std::clamp(note->y + m.px(18), 0.0F, std::max(0.0F, screen.y - size.y)));
  ImDrawList& draw = *ImGui::GetForegroundDrawList();
  draw.AddRectFilled(low, {low.x + size.x, low.y + size.y}, palette().popup, m.px(6));
  draw.AddRect(low, {low.x + size.x, low.y + size.y}, palette().warning, m.px(6));
  draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + pad, low.y + pad}, palette().text,
               note->text.c_str(), nullptr, wrap);
}

}  // namespace hariko
