#include "core/modeling/objects/parabolic_grid.hpp"

namespace hariko {

BicubicNet parabolic_grid(Index columns, Index rows, double width, double depth, double arch) {
  BicubicNet net{columns, rows, {}};
  for (Index j = 0; j < net.height(); ++j)
    for (Index i = 0; i < net.width(); ++i) {
      // Control points lie at thirds of each patch; the polar form of the parabola gives control points for
      // which all patches form one parabola.
      const Index segment = i == 3 * columns ? columns - 1 : i / 3, place = i - 3 * segment;
      const double a = 2.0 * segment / columns - 1, b = 2.0 * (segment + 1) / columns - 1;
      const double x = ((3 - double(place)) * a + double(place) * b) / 3;
      const double u = place > 0 ? b : a, v = place > 1 ? b : a, w = place > 2 ? b : a;
      const double square = (u * v + v * w + w * u) / 3;
      net.points.emplace_back(x * width / 2, (double(j) / (3.0 * rows) - 0.5) * depth, arch * (1 - square));
    }
  return net;
}

}  // namespace hariko
