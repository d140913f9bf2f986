// Notices over the viewport.

#include <algorithm>
#include <array>
#include <cstdio>

#include "ui/base/icons.hpp"
#include "ui/view/view_frame.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

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
    ImGui::AlignTextToFramePadding();
    coloured_text(error  ? palette().error
                  : info ? palette().secondary
                         : palette().warning,
                  error  ? icon::error
                  : info ? icon::info
                         : icon::warning);
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    text_in_lines(notice.text, width - m.px(48));
    if (!notice.remedy.empty()) coloured_lines(palette().dim_text, notice.remedy, width - m.px(48));
    ImGui::EndGroup();
    ImGui::SameLine(width - m.px(36));
    if (icon_button(context, icon::close, "notice." + std::to_string(number), context.tr("Dismiss"), false,
                    24))
      dismissed = number;
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

// The frame-time overlay: shares of the last frames in numbers and as a small history.

namespace {

constexpr double sixty_a_second = 1000.0 / 60;

std::string milliseconds(double value) {
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "%.1f ms", value);
  return text.data();
}

void draw_history(ImDrawList& list, const Metrics& m, const FrameTimes& times, ImVec2 low, ImVec2 high) {
  const double most = std::max(2 * sixty_a_second, times.total(0.95) * 1.2);
  const float step = (high.x - low.x) / float(FrameTimes::kept);
  const auto y_of = [&](double ms) {
    return high.y - (high.y - low.y) * static_cast<float>(std::min(1.0, ms / most));
  };
  list.AddRectFilled(low, high, with_alpha(palette().window, 0.6F));
  float x = high.x - step * float(times.samples().size());
  for (const FrameSample& sample : times.samples()) {
    list.AddRectFilled({x, y_of(sample.ours + sample.renderer)}, {x + step, y_of(sample.ours)},
                       with_alpha(palette().dim_text, 0.6F));
    list.AddRectFilled({x, y_of(sample.ours)}, {x + step, high.y}, palette().accent);
    x += step;
  }
  list.AddLine({low.x, y_of(sixty_a_second)}, {high.x, y_of(sixty_a_second)}, palette().good, m.px(1));
}

}  // namespace

void draw_frame_overlay(const PanelContext& context, const PanelRect& pane) {
  const FrameTimes& times = context.editor.frame_times;
  if (!times.visible) return;
  const Metrics& m = context.metrics;
  const Language& tr = context.tr;
  const Object* object = context.editor.active_object();
  const SurfaceView* view = object ? context.editor.view_of(object->id) : nullptr;
  struct Row {
    std::string name, middle, high;
  };
  std::vector<Row> rows{{tr("Frame time"), "p50", "p95"}};
  const auto row = [&](const char* name, double p50, double p95) {
    rows.push_back({name, milliseconds(p50), milliseconds(p95)});
  };
  row(tr("Our work"), times.ours(0.5), times.ours(0.95));
  row(tr("OpenGL"), times.renderer(0.5), times.renderer(0.95));
  row(tr("Together"), times.total(0.5), times.total(0.95));
  row(tr("Pointer to surface"), times.latency(0.5), times.latency(0.95));
  rows.push_back({tr("Last surface"), view ? milliseconds(view->milliseconds) : std::string(), ""});

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeight() + m.px(3), width = m.px(292), graph = m.px(44);
  const ImVec2 low(pane.min.x + m.px(8), pane.min.y + m.px(42));
  const ImVec2 high(low.x + width, low.y + line * float(rows.size()) + graph + m.px(24));
  list.AddRectFilled(low, high, palette().overlay, m.px(6));
  float y = low.y + m.px(8);
  for (const Row& r : rows) {
    const bool head = &r == rows.data();
    const ImU32 colour = head ? palette().dim_text : palette().text;
    list.AddText({low.x + m.px(10), y}, colour, r.name.c_str());
    const auto right = [&](const std::string& text, float x) {
      list.AddText({x - ImGui::CalcTextSize(text.c_str()).x, y}, colour, text.c_str());
    };
    right(r.middle, low.x + width - m.px(84));
    right(r.high, low.x + width - m.px(10));
    y += line;
  }
  draw_history(list, m, times, {low.x + m.px(10), y + m.px(4)}, {high.x - m.px(10), high.y - m.px(10)});
}

}  // namespace hariko
