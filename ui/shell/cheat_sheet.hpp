#pragma once

// The cheat sheet: every key at a glance, those of the tool in use first.

#include <string>
#include <utility>
#include <vector>

#include "ui/widgets/panels.hpp"

namespace hariko {

class CheatSheet {
 public:
  void open() { open_ = true; }
  bool is_open() const { return open_; }
  void close() { open_ = false; }
  void draw(PanelContext& context, float top);

 private:
  bool open_ = false;
};

/// A block of the sheet: rows of what is done and its keys; where the keys are empty the text is all.
struct CheatGroup {
  std::string title;
  std::vector<std::pair<std::string, std::string>> rows;
};

/// The blocks for what can be done now: the tool's hint, moving the view, then the menus.
std::vector<CheatGroup> cheat_groups(const PanelContext& context);

/// Column that each block stands in, by the blocks' heights, in their order from column to column, so that
/// the tallest column is as low as the order allows.
std::vector<int> columns_of(const std::vector<float>& heights, int columns);

/// The parts of a hint, which stand three spaces apart: "Orbit   Esc goes back".
std::vector<std::string> hint_parts(std::string_view hint);

}  // namespace hariko
