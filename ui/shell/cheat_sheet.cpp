#include "ui/shell/cheat_sheet.hpp"

#include <algorithm>
#include <numeric>

#include "ui/widgets/command_menu.hpp"
#include "ui/widgets/overlay_window.hpp"

namespace hariko {

namespace {

constexpr float row_height = 24, title_height = 30, gap_below = 16, column_gap = 32, keys_gap = 24;
constexpr int most_columns = 4;

float height_of(const CheatGroup& group, const Metrics& m) {
  return m.px(title_height + gap_below) + m.px(row_height) * static_cast<float>(group.rows.size());
}

/// Columns that the blocks need when none may be higher than `limit`, filled one after the other.
int columns_needed(const std::vector<float>& heights, float limit) {
  int columns = 1;
  float filled = 0;
  for (const float height : heights) {
    if (filled > 0 && filled + height > limit) {
      ++columns;
      filled = 0;
    }
    filled += height;
  }
  return columns;
}

void draw_group(const CheatGroup& group, ImVec2 at, float width, const Metrics& m) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(at, palette().accent, group.title.c_str());
  at.y += m.px(title_height);
  for (const auto& [text, keys] : group.rows) {
    const float end = keys.empty() ? at.x + width : draw_keys(list, m, at.x + width, at.y, keys) - m.px(8);
    list.AddText(at, palette().text, elided(text, end - at.x).c_str());
    at.y += m.px(row_height);
  }
}

}  // namespace

std::vector<std::string> hint_parts(std::string_view hint) {
  std::vector<std::string> parts;
  while (!hint.empty()) {
    const std::size_t end = hint.find("   ");
    if (end > 0) parts.emplace_back(hint.substr(0, end));
    if (end == std::string_view::npos) break;
    hint.remove_prefix(end + 3);
    hint.remove_prefix(std::min(hint.find_first_not_of(' '), hint.size()));
  }
  std::erase(parts, "|");
  return parts;
}

std::vector<CheatGroup> cheat_groups(const PanelContext& context) {
  const Language& tr = context.tr;
  std::vector<CheatGroup> groups;
  if (context.editor.has_document) {
    CheatGroup now{tr("Now, in the viewport"), {}};
    for (const std::string& part : hint_parts(context.tool_hint)) now.rows.emplace_back(part, "");
    groups.push_back(std::move(now));
  }
  for (const std::string& menu : context.commands.menus()) {
    CheatGroup group{tr(menu), {}};
    for (const Command& command : context.commands.all()) {
      const auto folders = menu_folders(command.menu);
      if (command.keys.empty() || folders.empty() || folders[0] != menu) continue;
      group.rows.emplace_back(tr(command.label), command.keys);
    }
    if (!group.rows.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<int> columns_of(const std::vector<float>& heights, int columns) {
  // The limit is a sum of neighbouring blocks: the least that fits is found by halving.
  float low = heights.empty() ? 0 : *std::max_element(heights.begin(), heights.end());
  float high = std::accumulate(heights.begin(), heights.end(), 0.0F);
  for (int i = 0; i < 40; ++i) {
    const float middle = (low + high) / 2;
    (columns_needed(heights, middle) <= columns ? high : low) = middle;
  }
  std::vector<int> out;
  int column = 0;
  float filled = 0;
  for (const float height : heights) {
    if (filled > 0 && filled + height > high && column + 1 < columns) {
      ++column;
      filled = 0;
    }
    filled += height;
    out.push_back(column);
  }
  return out;
}

void CheatSheet::draw(PanelContext& context, float top) {
  const Metrics& m = context.metrics;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = m.px(24), pad = m.px(24);
  const PanelRect most{{margin, top + m.px(12)}, {screen.x - margin, screen.y - m.px(24)}};
  const auto groups = open_ ? cheat_groups(context) : std::vector<CheatGroup>();
  float column = m.px(160);
  for (const CheatGroup& group : groups)
    for (const auto& [text, keys] : group.rows)
      column = std::max(column, ImGui::CalcTextSize(text.c_str()).x +
                                    (keys.empty() ? 0 : keys_width(m, keys) + m.px(keys_gap)));
  const float room = most.width() - 2 * pad - ImGui::GetStyle().ScrollbarSize;
  column = std::min(column, room);
  const int fitting = static_cast<int>((room + m.px(column_gap)) / (column + m.px(column_gap)));
  const int columns = std::clamp(std::min(fitting, static_cast<int>(groups.size())), 1, most_columns);
  std::vector<float> heights;
  for (const CheatGroup& group : groups) heights.push_back(height_of(group, m));
  const auto places = columns_of(heights, columns);
  std::vector<float> filled(static_cast<std::size_t>(columns), 0.0F);
  for (std::size_t i = 0; i < groups.size(); ++i) filled[static_cast<std::size_t>(places[i])] += heights[i];
  const float tallest = *std::max_element(filled.begin(), filled.end());

  const float width = static_cast<float>(columns) * (column + m.px(column_gap)) - m.px(column_gap) + 2 * pad +
                      ImGui::GetStyle().ScrollbarSize;
  const float height = std::min(most.height(), tallest + 2 * pad);
  const ImVec2 low((screen.x - width) / 2, most.min.y + (most.height() - height) / 2);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(pad, pad));
  const bool drawn = begin_overlay("###cheat_sheet", open_, {low, {low.x + width, low.y + height}}, m);
  ImGui::PopStyleVar();
  if (!drawn) return;
  context.marks.window("cheat_sheet");
  if (ImGui::BeginChild("keys", {0, 0}, false, ImGuiWindowFlags_NoNav)) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    std::vector<float> y(static_cast<std::size_t>(columns), 0.0F);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const auto place = static_cast<std::size_t>(places[i]);
      draw_group(groups[i],
                 {corner.x + static_cast<float>(place) * (column + m.px(column_gap)), corner.y + y[place]},
                 column, m);
      y[place] += heights[i];
    }
    ImGui::Dummy({1, tallest});
  }
  ImGui::EndChild();
  end_overlay();
}

}  // namespace hariko
