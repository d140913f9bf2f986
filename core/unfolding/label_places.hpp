#pragma once

// LabelPlaces: where numbers stand on a sheet so that none covers another.

#include <string>
#include <vector>

#include "core/unfolding/sheet_drawing.hpp"

namespace hariko {

/// A number that belongs to a side: it reads along it, and stands on the left of the way from `from` to `to`
/// or, with a negative `inset`, on the right.
struct SideLabel {
  Index page = 0;
  Vector2 from, to;
  double inset = 0;   ///< of its middle from the side at the full height, mm
  double height = 0;  ///< the most, mm
  std::string text;
  std::vector<Vector2> within;  ///< the convex polygon that it should not leave, counter-clockwise
};

/// Places labels one after the other, those of short sides first, as they have the least choice. Each takes
/// the middle of its side where that is free, else a place along the side, else a smaller height, down to a
/// third: what then has no place of its own stands in the middle. `taken`: texts that are there already. The
/// order of the result is that of the labels. A function of the input alone. O(labels) where they are spread
/// evenly.
std::vector<DrawnText> place_labels(const std::vector<SideLabel>& labels,
                                    const std::vector<DrawnText>& taken);

/// The corners of the box that a text covers, counter-clockwise.
std::array<Vector2, 4> box_of(const DrawnText& text);

}  // namespace hariko
