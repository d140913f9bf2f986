#pragma once

// Parameters of a subdivision curve after the deletion of a control point.

#include <algorithm>
#include <cmath>

namespace hariko {

/// Maps a parameter after the deletion of a control point: the two spans that met at it become one, later
/// ones are renumbered. `spans` is the number before, at least 2. On closed curves whole turns are kept;
/// where the first point is deleted, the seam moves to the next.
inline double deleted_parameter(double u, int spans, int point, bool closed) {
  const double turn = closed ? std::floor(u) : 0;
  double x = (u - turn) * spans;
  if (!closed && point == 0) {
    x = std::max(x - 1, 0.0);
  } else if (!closed && point == spans) {
    x = std::min(x, double(spans - 1));
  } else if (point == 0) {
    if (x < 1) x += spans;
    x = x <= spans - 1 ? x - 1 : spans - 2 + (x - (spans - 1)) / 2;
  } else if (x > point - 1) {
    x = x < point + 1 ? point - 1 + (x - (point - 1)) / 2 : x - 1;
  }
  return turn + x / (spans - 1);
}

}  // namespace hariko
