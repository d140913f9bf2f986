#pragma once

// ViewLayout: which views the window shows and where, and which of them the user works in. A value.

#include <array>
#include <optional>
#include <vector>

#include "ui/editor/view.hpp"

namespace hariko {

/// `two` puts something beside the free view: a plan now, later a paper model or correspondences.
enum class Arrangement { one, two, four };

/// A part of the viewport and the view that fills it. Fractions of the viewport's width and height.
struct Pane {
  int view = 0;
  float left = 0, top = 0, right = 1, bottom = 1;
};

class ViewLayout {
 public:
  static constexpr int count = 4;
  /// The free view and the three plans.
  std::array<View, count> views{View(StandardView::iso, false, true), View(StandardView::top, true, false),
                                View(StandardView::front, true, false),
                                View(StandardView::right, true, false)};
  /// Place of the middle when there are several views, in [least_split, 1 - least_split].
  float split_x = 0.5F, split_y = 0.5F;
  static constexpr float least_split = 0.15F;

  Arrangement arrangement() const { return arrangement_; }
  /// One view shows the active one; others make the first of theirs active if the active one is not shown.
  void arrange(Arrangement arrangement);
  /// The active view alone, or back to the arrangement of several before.
  void toggle_maximised();

  /// The view under the pointer, else the one that was worked in last.
  int active() const { return pointed_ && shows(*pointed_) ? *pointed_ : active_; }
  /// Something is done in a view: it stays active when the pointer leaves. Does nothing for views that are
  /// not shown.
  void activate(int view);
  /// The pointer is over a view, or, with nothing, has left them all: that alone lasts no longer.
  void point_at(std::optional<int> view) { pointed_ = view; }
  View& active_view() { return views[static_cast<std::size_t>(active())]; }
  const View& active_view() const { return views[static_cast<std::size_t>(active())]; }

  /// Side by side from left to right and top to bottom; they cover the viewport.
  std::vector<Pane> panes() const;
  bool shows(int view) const;
  /// Whether a view that shows is in flight.
  bool flying(double now) const;

 private:
  Arrangement arrangement_ = Arrangement::one, several_ = Arrangement::four;
  int active_ = 0;
  std::optional<int> pointed_;
};

}  // namespace hariko
