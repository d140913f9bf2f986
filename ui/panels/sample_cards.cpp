#include "ui/panels/sample_cards.hpp"

#include "ui/panels/overlay_window.hpp"
#include "ui/text_lines.hpp"

namespace hariko {

namespace {

struct Card {
  std::string id, title, subtitle, help;
  ImTextureID picture = nullptr;
};

constexpr float caption_height = 70;  // a title and two lines

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
  const float room = size.x - m.px(20);
  draw.AddText({at.x + m.px(12), picture_end.y + m.px(7)}, palette().text, elided(card.title, room).c_str());
  draw.AddText({at.x + m.px(12), picture_end.y + m.px(27)}, palette().dim_text,
               in_lines(card.subtitle, room, 2).c_str());
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

}  // namespace

bool draw_samples(PanelContext& context, float left, float width, int columns) {
  Grid grid(context, left, width, columns, 1.5F);
  bool chosen = false;
  const std::vector<Sample> all = context.samples;
  for (const Sample& sample : all) {
    const ImVec2 size = grid.next();
    if (!card(context,
              {"sample." + sample.path.filename().string(), context.tr(sample.title),
               context.tr(sample.description), context.tr(sample.description), sample.picture},
              size))
      continue;
    chosen = true;
    context.open(sample.path);
  }
  return chosen;
}

}  // namespace hariko
