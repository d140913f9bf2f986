#include "core/envelope/grid_summit.hpp"

#include <cmath>

namespace hariko {

namespace {

struct Differences {
  double first, second;
};

double at(const NeighbourValues& values, int column, int row) {
  return values[std::size_t(3 * (row + 1) + column + 1)];
}

Differences along(const NeighbourValues& values, int column, int row) {
  const double before = at(values, -column, -row), after = at(values, column, row);
  return {(after - before) / 2, after + before - 2 * at(values, 0, 0)};
}

Summit on_parabolas(const NeighbourValues& values) {
  constexpr int ways[][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  Summit best;
  for (const auto& [column, row] : ways) {
    const Differences d = along(values, column, row);
    // Differences that are not there compare as false.
    if (!(d.second < 0) || !(std::abs(d.first) <= -d.second)) continue;
    if (const double rise = -d.first * d.first / (2 * d.second); rise > best.rise)
      best = {-d.first / d.second * Vector2(column, row), rise};
  }
  return best;
}

}  // namespace

Summit summit_beside(const NeighbourValues& values) {
  const Differences x = along(values, 1, 0), y = along(values, 0, 1);
  const double mixed = (at(values, 1, 1) - at(values, 1, -1) - at(values, -1, 1) + at(values, -1, -1)) / 4;
  const double determinant = x.second * y.second - mixed * mixed;
  if (!(determinant > 0) || !(x.second < 0)) return on_parabolas(values);
  const Vector2 offset((mixed * y.first - y.second * x.first) / determinant,
                       (mixed * x.first - x.second * y.first) / determinant);
  if (offset.cwiseAbs().maxCoeff() > 1) return {};
  return {offset, (x.first * offset.x() + y.first * offset.y()) / 2};
}

}  // namespace hariko
