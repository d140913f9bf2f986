#pragma once

// BestTurn: how a set of points is turned to fit a page best.

#include <span>

#include "core/unfolding/piece_extent.hpp"

namespace hariko {

/// The turn at which points need the least of the room.
struct BestTurn {
  double angle = 0;   ///< radians, counter-clockwise
  double factor = 0;  ///< by which they could grow and still fit; below 1 they do not fit
  PaperSize size;     ///< of their box then
};

/// Looked for every degree, then closer round the best one. O(points). `points` is not empty.
BestTurn best_turn(std::span<const Vector2> points, const PaperSize& room);

}  // namespace hariko
