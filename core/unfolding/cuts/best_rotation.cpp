#include "core/unfolding/cuts/best_rotation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hariko {

BestTurn best_turn(std::span<const Vector2> points, const PaperSize& room) {
  const auto at = [&](double angle) {
    const Vector2 x(std::cos(angle), -std::sin(angle)), y(-x.y(), x.x());
    Vector2 low = Vector2::Constant(1e300), high = -low;
    for (const Vector2& p : points) {
      const Vector2 turned(x.dot(p), y.dot(p));
      low = low.cwiseMin(turned);
      high = high.cwiseMax(turned);
    }
    const PaperSize size{high.x() - low.x(), high.y() - low.y()};
    return BestTurn{angle, std::min(room.width / size.width, room.height / size.height), size};
  };
  constexpr double degree = std::numbers::pi / 180;
  BestTurn best = at(0);
  const auto consider = [&](double angle) {
    const BestTurn next = at(angle);
    if (next.factor > best.factor) best = next;
  };
  for (int k = 1; k < 180; ++k) consider(k * degree);
  for (double step = degree / 2; step > 1e-5; step /= 2) {
    const double middle = best.angle;
    consider(middle - step);
    consider(middle + step);
  }
  return best;
}

}  // namespace hariko
