#pragma once

// Correspondence between the points of two neighbouring sections: the lines of a strip, found by an exact
// dynamic program (fewest triangles first, then the nearest parameters).

#include <functional>
#include <span>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

/// Line between point a of the first section and point b of the second.
struct PointPair {
  int a = 0, b = 0;
  friend auto operator<=>(const PointPair&, const PointPair&) = default;
};

/// Cost of a line between points a and b, defined for every pair of points.
using PairCost = std::function<double(int a, int b)>;

/// Cost (u_a - u_b)^2 - 1e-9 (u_a - 1/2)(u_b - 1/2), whose small second term breaks ties equally for mirror
/// images; for closed sections the square of the cyclic difference of u_a + start and u_b, where `start` is
/// the parameter of the second section that corresponds to 0 of the first. `points_a`, `points_b`: numbers of
/// points; a section of one point is a tip.
PairCost parameter_cost(int points_a, int points_b, bool closed, double start = 0);

/// Lines in order. Open: from (0, 0) to the last points; closed: cyclically, winding once; from each line to
/// the next a, b or both increase by one. Minimises first the number of steps in which only one increases,
/// then the sum of costs, under the condition that every forced pair is a line. Errors: E_LINK_CROSS (forced
/// pairs that cross). O(a b); O(a b^2) for closed sections without forced pairs.
Result<std::vector<PointPair>> correspondence(int points_a, int points_b, bool closed, const PairCost& cost,
                                              std::span<const PointPair> forced);

}  // namespace hariko
