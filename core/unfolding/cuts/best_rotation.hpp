#pragma once

// BestTurn: rotation at which a set of points fits a page best.

#include <span>

#include "core/unfolding/pages/piece_extent.hpp"

namespace hariko {

/// Rotation at which a set of points needs the smallest part of the page.
struct BestTurn {
  double angle = 0;   ///< radians, counter-clockwise
  double factor = 0;  ///< by which the points could be scaled and still fit; below 1 they do not fit
  PaperSize size;     ///< box of the points at this angle
};

/// Best rotation over all whole degrees of a half turn, refined round the best one to 1e-5 radians.
/// O(points). `points` must not be empty.
BestTurn best_turn(std::span<const Vector2> points, const PaperSize& room);

}  // namespace hariko
