#include "ui/widgets/card_focus.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/theme.hpp"

namespace hariko {

namespace {

bool overlap(float low_a, float high_a, float low_b, float high_b) {
  return low_a < high_b && low_b < high_a;
}

}  // namespace

std::size_t CardFocus::place() const {
  const auto found = std::ranges::find_if(items_, [this](const Placed& item) { return item.id == focused_; });
  return static_cast<std::size_t>(found - items_.begin());
}

std::size_t CardFocus::beside(std::size_t from, int step) const {
  const Placed& here = items_[from];
  std::size_t best = from;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Placed& other = items_[i];
    const float way = static_cast<float>(step) * (other.low.x - here.low.x);
    if (way <= 0 || !overlap(other.low.y, other.high.y, here.low.y, here.high.y)) continue;
    if (best == from || way < static_cast<float>(step) * (items_[best].low.x - here.low.x)) best = i;
  }
  return best;
}

std::size_t CardFocus::in_row(std::size_t from, bool below) const {
  const Placed& here = items_[from];
  const auto middle = [](const Placed& item) { return (item.low.x + item.high.x) / 2; };
  // Distance to the row, then to the side.
  const auto way = [&](const Placed& other) {
    const float down = below ? other.low.y - here.high.y : here.low.y - other.high.y;
    return std::pair(std::round(down), std::abs(middle(other) - middle(here)));
  };
  std::size_t best = from;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (way(items_[i]).first < 0) continue;
    if (best == from || way(items_[i]) < way(items_[best])) best = i;
  }
  return best;
}

void CardFocus::go(std::size_t to) {
  focused_ = items_[to].id;
  scroll_ = true;
}

bool CardFocus::key(const KeyChord& chord) {
  if (items_.empty() || chord.control || chord.alt) return false;
  const std::size_t count = items_.size(), at = place();
  const bool nowhere = at == count;
  switch (chord.key) {
    case Key::tab:
      if (chord.shift)
        go(nowhere ? count - 1 : (at + count - 1) % count);
      else
        go(nowhere ? 0 : (at + 1) % count);
      return true;
    case Key::home:
      return go(0), true;
    case Key::end:
      return go(count - 1), true;
    case Key::left:
    case Key::right:
      return go(nowhere ? 0 : beside(at, chord.key == Key::right ? 1 : -1)), true;
    case Key::up:
    case Key::down:
      return go(nowhere ? 0 : in_row(at, chord.key == Key::down)), true;
    case Key::enter:
    case Key::keypad_enter:
    case Key::space:
      choose_ = !nowhere;
      return choose_;
    default:
      return false;
  }
}

void CardFocus::begin() {
  drawn_.clear();
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) focused_.clear();
}

void CardFocus::end() {
  std::swap(items_, drawn_);
  choose_ = false;
}

bool CardFocus::item(const std::string& id, float rounding) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  drawn_.push_back({id, low, high});
  if (id != focused_) return false;
  constexpr float gap = 3, width = 2;
  ImGui::GetWindowDrawList()->AddRect({low.x - gap, low.y - gap}, {high.x + gap, high.y + gap},
                                      palette().secondary, rounding + gap, 0, width);
  const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
  if (std::exchange(scroll_, false) && (low.y < top || high.y > bottom))
    ImGui::SetScrollFromPosY((low.y + high.y) / 2 - top, 0.5F);
  return choose_;
}

}  // namespace hariko
