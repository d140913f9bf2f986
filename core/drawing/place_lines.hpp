#pragma once

// Curves that are traced on the grid of a surface, as places of the surface itself.

#include <functional>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Place on a surface, where a traced curve passes.
struct SurfacePlace {
  Index patch;
  Vector2 parameter;
  Vector3 position;  ///< world
  double edge;       ///< length of the grid edge with the place
};

/// Curve on a surface; a closed one repeats its first place at the end.
using PlaceLine = std::vector<SurfacePlace>;

/// Whether a curve is closed.
bool is_closed(const PlaceLine& line);

/// Joins open curves whose ends lie at the same place, within 1e-3 of a grid edge, on different patches.
/// O(curves log curves), plus the pairs of ends that are near along x.
void join_lines(std::vector<PlaceLine>& lines);

/// Fraction of the way along a grid edge, 0..1 to within 1e-9, at which a continuous function that is given
/// by that fraction changes its sign. `at_begin` and `at_end` are its values at the ends; values down to
/// `-noise` count as positive.
double crossing_fraction(const std::function<double(double)>& value, double at_begin, double at_end,
                         double noise);

}  // namespace hariko
