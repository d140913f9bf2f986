#include "core/cad/fit/side_tie.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// Spline spaces along a side and across it.
struct SideSpaces {
  const SplineSpace &along, &across;
  bool horizontal, at_end;
  double end() const { return at_end ? across.end() : across.begin(); }
  PointShare share(std::size_t along_it, std::size_t beside, double factor) const {
    return horizontal ? PointShare{along_it, beside, factor} : PointShare{beside, along_it, factor};
  }
};
SideSpaces spaces_of(const SplineSurface& surface, int side) {
  const bool horizontal = side % 2 == 0;
  return {horizontal ? surface.s : surface.t, horizontal ? surface.t : surface.s, horizontal,
          side == 1 || side == 2};
}

}  // namespace

bool has_normal(const PatchPoint& point) {
  return point.ds.cross(point.dt).norm() > 1e-5 * point.ds.norm() * point.dt.norm();
}

Vector2 move_in(const PatchPoint& point, const Vector3& direction) {
  const double e = point.ds.squaredNorm(), f = point.ds.dot(point.dt), g = point.dt.squaredNorm(),
               area = e * g - f * f;
  return {(g * point.ds.dot(direction) - f * point.dt.dot(direction)) / area,
          (e * point.dt.dot(direction) - f * point.ds.dot(direction)) / area};
}

NormalBend normal_bend(const PatchPoint& point, const Vector3& direction) {
  const Vector3 normal = unit_normal(point);
  const double e = point.ds.squaredNorm(), f = point.ds.dot(point.dt), g = point.dt.squaredNorm(),
               area = e * g - f * f;
  const double l = normal.dot(point.dss), m = normal.dot(point.dst), n = normal.dot(point.dtt);
  const Vector2 move = move_in(point, direction);
  const double mean = (e * n - 2 * f * m + g * l) / (2 * area), gauss = (l * n - m * m) / area;
  return {move.x() * move.x() * l + 2 * move.x() * move.y() * m + move.y() * move.y() * n,
          std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss))};
}

Vector3 SideTie::sum(const SplineSurface& surface) const {
  Vector3 out = Vector3::Zero();
  for (const PointShare& share : shares)
    out += share.factor * surface.points[surface.index(share.i, share.j)];
  return out;
}

SideTie turn_tie(const SplineSurface& surface, int side, double at, const Vector3& normal, double speed) {
  const SideSpaces spaces = spaces_of(surface, side);
  const SplineBasis along = spline_basis(spaces.along, spaces.along.knots(), at),
                    across = spline_basis(spaces.across, spaces.across.knots(), spaces.end());
  SideTie out{normal, {}};
  for (std::size_t r = 0; r <= std::size_t(spaces.across.degree); ++r)
    for (std::size_t k = 0; k <= std::size_t(spaces.along.degree); ++k)
      if (const double factor = along.value[k] * across.derivative[r] / speed; factor != 0)
        out.shares.push_back(spaces.share(along.first + k, across.first + r, factor));
  return out;
}

SideTie bend_tie(const SplineSurface& surface, int side, double at, const Vector3& normal, double along,
                 double over) {
  const SideSpaces spaces = spaces_of(surface, side);
  const SplineBasis a = spline_basis(spaces.along, spaces.along.knots(), at),
                    b = spline_basis(spaces.across, spaces.across.knots(), spaces.end());
  SideTie out{normal, {}};
  for (std::size_t r = 0; r <= std::size_t(spaces.across.degree); ++r)
    for (std::size_t k = 0; k <= std::size_t(spaces.along.degree); ++k) {
      const double factor = along * along * a.second[k] * b.value[r] +
                            2 * along * over * a.derivative[k] * b.derivative[r] +
                            over * over * a.value[k] * b.second[r];
      if (factor != 0) out.shares.push_back(spaces.share(a.first + k, b.first + r, factor));
    }
  return out;
}

}  // namespace hariko
