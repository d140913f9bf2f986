#include "ui/editor/view_layout.hpp"

#include <algorithm>

namespace hariko {

namespace {

constexpr int free_view = 0, top_view = 1, front_view = 2, right_view = 3;

}  // namespace

void ViewLayout::arrange(Arrangement arrangement) {
  active_ = active();
  arrangement_ = arrangement;
  if (arrangement != Arrangement::one) several_ = arrangement;
  if (!shows(active_)) active_ = free_view;
  pointed_.reset();
}

void ViewLayout::toggle_maximised() {
  arrange(arrangement_ == Arrangement::one ? several_ : Arrangement::one);
}

void ViewLayout::activate(int view) {
  if (!shows(view)) return;
  active_ = view;
  pointed_.reset();
}

std::vector<Pane> ViewLayout::panes() const {
  const float x = std::clamp(split_x, least_split, 1 - least_split);
  const float y = std::clamp(split_y, least_split, 1 - least_split);
  switch (arrangement_) {
    case Arrangement::two:
      return {{free_view, 0, 0, x, 1}, {top_view, x, 0, 1, 1}};
    case Arrangement::four:
      return {{top_view, 0, 0, x, y},
              {free_view, x, 0, 1, y},
              {front_view, 0, y, x, 1},
              {right_view, x, y, 1, 1}};
    default:
      return {{active_, 0, 0, 1, 1}};
  }
}

bool ViewLayout::shows(int view) const {
  const auto shown = panes();
  return std::ranges::any_of(shown, [&](const Pane& pane) { return pane.view == view; });
}

bool ViewLayout::flying(double now) const {
  const auto shown = panes();
  return std::ranges::any_of(
      shown, [&](const Pane& pane) { return views[static_cast<std::size_t>(pane.view)].flying(now); });
}

}  // namespace hariko
