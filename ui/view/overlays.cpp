// Notices over the viewport.

#include <algorithm>
#include <cmath>

#include "ui/base/icons.hpp"
#include "ui/base/text_lines.hpp"
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
    ImGui::PushStyleColor(ImGuiCol_Text, error  ? palette().error
                                         : info ? palette().secondary
                                                : palette().warning);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(error ? icon::error : info ? icon::info : icon::warning);
    ImGui::PopStyleColor();
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    text_in_lines(notice.text, width - m.px(48));
    if (!notice.remedy.empty()) {
      const TextColour dim(palette().dim_text);
      text_in_lines(notice.remedy, width - m.px(48));
    }
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
