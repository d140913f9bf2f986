// The start page: work to recover, ways to begin, recent files and samples.

#include <algorithm>
#include <chrono>

#include "ui/fonts.hpp"
#include "ui/icons.hpp"
#include "ui/panels/offers_panel.hpp"
#include "ui/panels/panels.hpp"

namespace hariko {

namespace {

struct Card {
  std::string id, title, subtitle, help;
  ImTextureID picture = nullptr;
};

constexpr float caption_height = 52;

/// A card with a picture. True when it was clicked.
bool card(PanelContext& context, const Card& card, ImVec2 size) {
  const Metrics& m = context.metrics;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton(card.id.c_str(), size);
  context.marks.item(card.id);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered && !card.help.empty()) ImGui::SetTooltip("%s", card.help.c_str());
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 end(at.x + size.x, at.y + size.y);
  const float caption = m.px(caption_height), radius = m.px(6);
  draw.AddRectFilled(at, end, hovered ? palette().field_hover : palette().panel, radius);
  const ImVec2 picture_end(end.x, end.y - caption);
  if (card.picture)
    draw.AddImageRounded(card.picture, at, picture_end, {0, 0}, {1, 1}, IM_COL32_WHITE, radius,
                         ImDrawFlags_RoundCornersTop);
  else
    draw.AddRectFilled(at, picture_end, palette().field, radius, ImDrawFlags_RoundCornersTop);
  draw.PushClipRect({at.x + m.px(12), at.y}, {end.x - m.px(8), end.y}, true);
  draw.AddText({at.x + m.px(12), picture_end.y + m.px(7)}, palette().text, card.title.c_str());
  draw.AddText({at.x + m.px(12), picture_end.y + m.px(27)}, palette().dim_text, card.subtitle.c_str());
  draw.PopClipRect();
  if (hovered) draw.AddRect(at, end, palette().secondary, radius, 0, m.px(1.5F));
  return clicked;
}

/// Places cards of equal size in rows, from the left edge of the content.
class Grid {
 public:
  Grid(const PanelContext& context, float left, float content, int columns, float aspect)
      : left_(left), spacing_(context.metrics.px(16)), columns_(columns), top_(ImGui::GetCursorPosY()) {
    const float width = (content - spacing_ * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    size_ = {width, width / aspect + context.metrics.px(caption_height)};
  }
  /// Moves to the next place.
  ImVec2 next(float below = 0) {
    const int column = count_ % columns_, row = count_ / columns_;
    ++count_;
    ImGui::SetCursorPos({left_ + static_cast<float>(column) * (size_.x + spacing_),
                         top_ + static_cast<float>(row) * (size_.y + below + spacing_)});
    return size_;
  }

 private:
  float left_, spacing_;
  int columns_, count_ = 0;
  float top_;
  ImVec2 size_{};
};

void section(PanelContext& context, float left, const char* title) {
  ImGui::Dummy({0, context.metrics.px(10)});
  ImGui::SetCursorPosX(left);
  ImGui::TextDisabled("%s", context.tr(title));
  ImGui::Dummy({0, context.metrics.px(2)});
}

/// Calls draw(width) under a title, in the page's column.
template <class Draw>
void section_of(PanelContext& context, float left, const char* title, const Draw& draw) {
  section(context, left, title);
  ImGui::SetCursorPosX(left);
  ImGui::BeginGroup();
  draw();
  ImGui::EndGroup();
}

void earlier_work(PanelContext& context, float left, float content) {
  if (!context.offers.recoveries.empty())
    section_of(context, left, "Unsaved work of an earlier session",
               [&] { draw_recovery_offers(context, content); });
  if (!context.offers.recent.empty())
    section_of(context, left, "Recent files",
               [&] { draw_recent_files(context, content, content > context.metrics.px(820) ? 6 : 4); });
}

void samples(PanelContext& context, float left, float content, int columns) {
  section(context, left, context.samples.empty() ? "The samples are not installed." : "Samples");
  Grid grid(context, left, content, columns, 1.5F);
  const std::vector<Sample> all = context.samples;
  for (const Sample& sample : all) {
    const ImVec2 size = grid.next();
    if (card(context,
             {"sample." + sample.path.filename().string(), context.tr(sample.title),
              context.tr(sample.description), context.tr(sample.description), sample.picture},
             size))
      context.open(sample.path);
  }
}

bool main_button(const char* label) {
  ImGui::PushStyleColor(ImGuiCol_Button, palette().accent);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, IM_COL32(255, 178, 84, 255));
  ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(30, 31, 34, 255));
  const bool pressed = ImGui::Button(label);
  ImGui::PopStyleColor(3);
  return pressed;
}

void actions(PanelContext& context) {
  const Language& tr = context.tr;
  const auto label = [&](const char* symbol, const char* text) { return std::string(symbol) + "  " + text; };
  if (main_button(label(icon::object, tr("New from box")).c_str())) context.run("file.new_from_box");
  context.marks.item("start.box");
  ImGui::SameLine();
  if (ImGui::Button(label(icon::open, tr("Open\u2026")).c_str())) context.run("file.open");
  context.marks.item("start.open");
  ImGui::SameLine();
  if (ImGui::Button(label(icon::import_file, tr("Import a mesh\u2026")).c_str())) context.run("file.import");
  context.marks.item("start.import");
  ImGui::SameLine();
  const Guide& guide = context.editor.guide;
  const char* text =
      guide.paused() ? tr("Go on with your first model") : tr("Your first model in two minutes");
  if (ImGui::Button(label(icon::info, text).c_str())) context.run("help.guide");
  context.marks.item("start.guide");
  ImGui::TextDisabled("%s", tr("or drop a file here: .hariko, .obj, .off, .ply, .stl"));
}

}  // namespace

void draw_start_page(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  const int columns = rect.width() > m.px(900) ? 4 : 3;
  const float content = std::min(rect.width() - m.px(64), m.px(1080));
  const float left = (rect.width() - content) / 2;
  if (begin_panel("Start", rect, palette().window, {0, 0})) {
    ImGui::SetCursorPos({left, m.px(28)});
    ImGui::BeginGroup();
    ImGui::PushFont(title_font());
    ImGui::TextUnformatted("Hariko");
    ImGui::PopFont();
    ImGui::TextDisabled("%s", context.tr("Stretch a smooth surface over a rough structure."));
    ImGui::Dummy({0, m.px(8)});
    actions(context);
    ImGui::EndGroup();
    earlier_work(context, left, content);
    samples(context, left, content, columns);
    ImGui::Dummy({1, m.px(24)});
  }
  ImGui::End();
}

}  // namespace hariko
