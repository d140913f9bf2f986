// The start page: samples to begin with, and the ways to open something else.

#include <algorithm>

#include "ui/fonts.hpp"
#include "ui/icons.hpp"
#include "ui/panels/offers_panel.hpp"
#include "ui/panels/panels.hpp"

namespace hariko {

namespace {

/// A card with a picture. True when it was clicked.
bool sample_card(PanelContext& context, const Sample& sample, ImVec2 size) {
  const Metrics& m = context.metrics;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton(sample.path.c_str(), size);
  context.marks.item("sample." + sample.path.filename().string());
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetTooltip("%s", sample.description.c_str());
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + size.x, at.y + size.y);
  const float caption = m.px(34), radius = m.px(6);
  draw.AddRectFilled(at, end, hovered ? palette().field_hover : palette().panel, radius);
  const ImVec2 picture_end(end.x, end.y - caption);
  if (sample.picture)
    draw.AddImageRounded(sample.picture, at, picture_end, {0, 0}, {1, 1}, IM_COL32_WHITE, radius,
                         ImDrawFlags_RoundCornersTop);
  else
    draw.AddRectFilled(at, picture_end, palette().field, radius, ImDrawFlags_RoundCornersTop);
  draw.AddText({at.x + m.px(12), picture_end.y + m.px(8)}, palette().text, sample.title.c_str());
  if (hovered) draw.AddRect(at, end, palette().secondary, radius, 0, m.px(1.5F));
  return clicked;
}

}  // namespace

void draw_start_page(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  const int columns = rect.width() > m.px(900) ? 4 : 3;
  const float spacing = m.px(16);
  const float content = std::min(rect.width() - m.px(64), m.px(1080));
  const float left = (rect.width() - content) / 2;
  if (begin_panel("Start", rect, palette().window, {0, 0})) {
    ImGui::SetCursorPos({left, m.px(28)});
    ImGui::BeginGroup();
    ImGui::PushFont(title_font());
    ImGui::TextUnformatted("Hariko");
    ImGui::PopFont();
    ImGui::TextDisabled("Stretch a smooth surface over a rough structure.");
    ImGui::Dummy({0, m.px(8)});
    if (ImGui::Button((std::string(icon::open) + "  Open\u2026").c_str())) context.run("file.open");
    context.marks.item("start.open");
    ImGui::SameLine();
    if (ImGui::Button((std::string(icon::import_file) + "  Import a mesh\u2026").c_str()))
      context.run("file.import");
    context.marks.item("start.import");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("or drop a file here: .hariko, .obj, .off, .ply, .stl");
    ImGui::Dummy({0, m.px(12)});
    if (!context.offers.recoveries.empty()) {
      heading(context, context.tr("Unsaved work of an earlier session"));
      draw_recovery_offers(context, content);
      ImGui::Dummy({0, m.px(8)});
    }
    if (!context.offers.recent.empty()) {
      heading(context, context.tr("Recent files"));
      draw_recent_files(context, content, content > m.px(820) ? 6 : 4);
      ImGui::Dummy({0, m.px(8)});
    }
    ImGui::TextDisabled(context.samples.empty() ? "The samples are not installed." : "Samples");
    ImGui::EndGroup();
    const float width = (content - spacing * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    const ImVec2 size(width, width / 1.5F + m.px(34));
    const float top = ImGui::GetCursorPosY() + m.px(4);
    const std::vector<Sample> samples = context.samples;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto column = static_cast<float>(i % static_cast<std::size_t>(columns));
      const std::size_t whole_rows = i / static_cast<std::size_t>(columns);
      const auto row = static_cast<float>(whole_rows);
      ImGui::SetCursorPos({left + column * (width + spacing), top + row * (size.y + spacing)});
      if (sample_card(context, samples[i], size)) context.open(samples[i].path);
    }
    ImGui::Dummy({1, m.px(24)});
  }
  ImGui::End();
}

}  // namespace hariko
