#include "ui/widgets/sample_cards.hpp"

#include <algorithm>
#include <utility>

#include "ui/base/text_lines.hpp"
#include "ui/base/texture.hpp"
#include "ui/widgets/application_services.hpp"
#include "ui/widgets/card_focus.hpp"
#include "ui/widgets/command_services.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

constexpr float picture_aspect = 1.5F;
constexpr float padding = 12, spacing = 16, above_title = 8, above_text = 23, below_text = 9;  ///< points

/// A picture that fills a place: its middle, where it is higher or wider.
void fill_with(const Picture& picture, ImVec2 low, ImVec2 high, float radius) {
  ImVec2 first{0, 0}, last{1, 1};
  const float place = (high.x - low.x) / (high.y - low.y);
  if (picture.aspect < place)
    first.y = (1 - picture.aspect / place) / 2, last.y = 1 - first.y;
  else
    first.x = (1 - place / picture.aspect) / 2, last.x = 1 - first.x;
  const auto used = [&](ImVec2 at) { return ImVec2(at.x * picture.used.x, at.y * picture.used.y); };
  ImGui::GetWindowDrawList()->AddImageRounded(imgui_texture(picture.texture), low, high, used(first),
                                              used(last), IM_COL32_WHITE, radius,
                                              ImDrawFlags_RoundCornersTop);
}

/// True when it was chosen.
bool draw_card(PanelContext& context, const Card& card, ImVec2 size, std::size_t lines) {
  const Metrics& m = context.metrics;
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + size.x, low.y + size.y);
  bool chosen = area_button(context.marks, card.id, size);
  const bool hovered = ImGui::IsItemHovered();
  const float radius = m.px(6);
  if (context.focus && context.focus->item(card.id, radius)) chosen = true;
  if (hovered && !card.help.empty()) show_tip(card.help.c_str());
  if (!ImGui::IsRectVisible(low, high)) return chosen;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(low, high, hovered ? palette().field_hover : palette().panel, radius);
  const ImVec2 picture_high(high.x, low.y + size.x / picture_aspect);
  if (card.pictured && !card.pictured->wanted) context.application.give_picture(*card.pictured);
  if (card.pictured && card.pictured->picture.texture != 0)
    fill_with(card.pictured->picture, low, picture_high, radius);
  else
    draw.AddRectFilled(low, picture_high, palette().field, radius, ImDrawFlags_RoundCornersTop);
  if (card.paint) card.paint(low, picture_high);
  const float room = size.x - 2 * m.px(padding), left = low.x + m.px(padding);
  draw.AddText({left, picture_high.y + m.px(above_title)}, palette().text,
               in_lines(card.title, room, 1).c_str());
  draw.AddText({left, picture_high.y + m.px(above_title + above_text)}, palette().dim_text,
               in_lines(card.text, room, lines).c_str());
  if (hovered) draw.AddRect(low, high, palette().secondary, radius, 0, m.px(1.5F));
  return chosen;
}

}  // namespace

int CardGrid::draw(std::size_t lines) const {
  const Metrics& m = context_.metrics;
  const float gap = m.px(spacing), top = ImGui::GetCursorPosY();
  const float column = (width_ - gap * static_cast<float>(columns_ - 1)) / static_cast<float>(columns_);
  std::size_t longest = 1;
  for (const Card& card : cards_) {
    const std::string text = in_lines(card.text, column - 2 * m.px(padding), lines);
    longest = std::max(longest, 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')));
  }
  const ImVec2 size(column, column / picture_aspect + m.px(above_title + above_text + below_text) +
                                static_cast<float>(longest) * ImGui::GetTextLineHeight());
  int chosen = -1;
  for (int i = 0; i < static_cast<int>(cards_.size()); ++i) {
    ImGui::SetCursorPos({left_ + static_cast<float>(i % columns_) * (size.x + gap),
                         top + static_cast<float>(i / columns_) * (size.y + gap)});
    if (draw_card(context_, cards_[static_cast<std::size_t>(i)], size, longest)) chosen = i;
  }
  return chosen;
}

const char* heading_of(Beginning beginning) {
  return name_among(beginning, {"Polyhedron", "Solids", "Sections", "Outline", "Others"});
}

bool draw_samples(PanelContext& context, float left, float width, int columns) {
  bool chosen = false;
  bool first = true;
  for (const Beginning beginning : beginnings) {
    std::vector<std::filesystem::path> paths;
    CardGrid grid(context, left, width, columns);
    for (Sample& sample : context.samples) {
      if (sample.beginning != beginning) continue;
      paths.push_back(sample.path);
      grid.add({"sample." + sample.path.filename().string(), context.tr(sample.title),
                context.tr(sample.description), context.tr(sample.description), &sample});
    }
    if (paths.empty()) continue;
    ImGui::Dummy({0, context.metrics.px(std::exchange(first, false) ? 0 : 8)});
    ImGui::SetCursorPosX(left);
    ImGui::TextDisabled("%s", context.tr(heading_of(beginning)));
    constexpr std::size_t lines = 2;
    const int picked = grid.draw(lines);
    if (picked < 0) continue;
    chosen = true;
    context.services.open_guarded(paths[static_cast<std::size_t>(picked)]);
  }
  return chosen;
}

}  // namespace hariko
