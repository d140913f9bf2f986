#pragma once

// The summit of a function that is known at the nodes of a grid, between them.

#include <array>

#include "core/base/vector.hpp"

namespace hariko {

/// At a node and its eight neighbours: value of (column, row), both -1 .. 1, at 3 (row + 1) + column + 1. NaN
/// beyond a border.
using NeighbourValues = std::array<double, 9>;

struct Summit {
  Vector2 offset = Vector2::Zero();  ///< from the node, in intervals, at most 1 each way
  double rise = 0;                   ///< above the node's value
};

/// Of the paraboloid through the values; where some of them are missing, or it has no summit beside the node,
/// of the highest parabola along a row, a column or a diagonal. The node itself where these have none either.
Summit summit_beside(const NeighbourValues& values);

}  // namespace hariko
