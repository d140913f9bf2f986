#include "ui/base/section_shape.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace hariko {

ShapePoints shape_points(SectionShape shape, const Vector3& middle, const Matrix3& axes,
                         const Vector2& half) {
  ShapePoints out;
  const auto add = [&](double x, double y, bool sharp) {
    out.points.push_back(middle + x * axes.col(0) + y * axes.col(1));
    out.sharp.push_back(sharp ? 1 : 0);
  };
  if (shape == SectionShape::rectangle) {
    constexpr std::array<std::array<double, 2>, 4> corners{{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
    for (const auto& corner : corners) add(corner[0] * half.x(), corner[1] * half.y(), true);
    return out;
  }
  // Through so many points a cubic curve is round to a ten thousandth.
  constexpr int count = 8;
  const double height = shape == SectionShape::circle ? half.x() : half.y();
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    add(half.x() * std::cos(angle), height * std::sin(angle), false);
  }
  return out;
}

}  // namespace hariko
