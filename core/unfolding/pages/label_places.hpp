#pragma once

// Label placement: numbers on a sheet that do not cover each other.

#include <string>
#include <vector>

#include "core/unfolding/pages/sheet_drawing.hpp"

namespace hariko {

/// Number that belongs to a side. It reads along the side and stands to the left of the direction from `from`
/// to `to` or, with a negative `inset`, to the right.
struct SideLabel {
  Index page = 0;
  Vector2 from, to;
  double inset = 0;   ///< distance of its centre from the side at full height, mm
  double height = 0;  ///< full height, mm
  std::string text;
  std::vector<Vector2> within;  ///< convex polygon that it should stay in, counter-clockwise
};

/// Places labels one after the other, those of short sides first, as they have the fewest choices. Each gets
/// the middle of its side where that is free, else a place along the side, else a smaller height, down to a
/// third; a label without any free place goes to the middle. `taken`: texts already on the sheet. The result
/// has the order of the labels and depends on the arguments alone. O(labels) where they are spread evenly.
std::vector<DrawnText> place_labels(const std::vector<SideLabel>& labels,
                                    const std::vector<DrawnText>& taken);

/// Corners of the box that a text covers, counter-clockwise.
std::array<Vector2, 4> box_of(const DrawnText& text);

}  // namespace hariko
