#include "core/analysis/combs.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/base/parallel.hpp"

namespace hariko {

namespace {

/// Inset at the ends of a curve, as a share of it. At a patch's corners second derivatives may depend on the
/// direction, so those of the side curve are taken slightly inside.
constexpr double inside = 1e-6;

/// Side of a patch, or a part of a side.
struct Curve {
  PatchSide side;
  double begin = 0, end = 1;
  Element source;
};

std::vector<Curve> curves_of(const Surface& surface) {
  std::vector<Curve> curves;
  for (const Seam& seam : surface.seams())
    if (seam.source.kind == Element::Kind::edge)
      curves.push_back({seam.first, seam.first_begin, seam.first_end, seam.source});
  const auto& sides = surface.boundary_sides();
  for (std::size_t i = 0; i < sides.size(); ++i)
    curves.push_back({sides[i], 0, 1, surface.boundary_sources()[i]});
  return curves;
}

/// Tooth of a comb: minus the curvature vector of the curve through `point` with parameter direction `along`.
Vector3 tooth(const PatchPoint& point, const Vector2& along) {
  const Vector3 first = along.x() * point.ds + along.y() * point.dt;
  const Vector3 second = along.x() * along.x() * point.dss + 2 * along.x() * along.y() * point.dst +
                         along.y() * along.y() * point.dtt;
  const double speed = first.squaredNorm();
  const Vector3 curvature = (second - first * (first.dot(second) / speed)) / speed;
  return curvature.allFinite() ? Vector3(-curvature) : Vector3::Zero();
}

}  // namespace

CurvatureCombs curvature_combs(const Surface& surface, int density, const CancelToken& cancel) {
  HARIKO_ASSERT(density >= 1, "a density is at least 1");
  CurvatureCombs combs;
  combs.density = density;
  if (surface.patch_count() == 0) return combs;
  const std::vector<Curve> curves = curves_of(surface);
  const std::size_t stride = static_cast<std::size_t>(density) + 1;
  combs.points.resize(curves.size() * stride);
  combs.teeth.resize(curves.size() * stride);
  const Domain domain = surface.domain();
  parallel_for(curves.size(), 32, [&](std::size_t begin, std::size_t end) {
    if (cancel.cancelled()) return;
    for (std::size_t c = begin; c < end; ++c) {
      const Curve& curve = curves[c];
      const Vector2 along =
          side_parameter(domain, curve.side.side, 1) - side_parameter(domain, curve.side.side, 0);
      const int corners = corner_count(domain);
      const auto exact = [&](int corner) {
        return surface.patches().second_order_at_corner(curve.side.patch, corner % corners) ==
               CornerSecondOrder::exact;
      };
      const double margin = exact(curve.side.side) && exact(curve.side.side + 1) ? 0 : inside;
      for (int i = 0; i <= density; ++i) {
        const auto at = [&](double x, Order order) {
          const double fraction = curve.begin + x * (curve.end - curve.begin);
          return surface.patches().evaluate(curve.side.patch,
                                            side_parameter(domain, curve.side.side, fraction), order);
        };
        const double x = grid_fraction(i, density);
        combs.points[c * stride + static_cast<std::size_t>(i)] = at(x, Order::first).position;
        combs.teeth[c * stride + static_cast<std::size_t>(i)] =
            tooth(at(std::clamp(x, margin, 1 - margin), Order::second), along);
      }
    }
  });
  if (cancel.cancelled()) return {};
  combs.sources.reserve(curves.size());
  for (const Curve& curve : curves) combs.sources.push_back(curve.source);
  return combs;
}

double typical_curvature(const CurvatureCombs& combs) {
  if (combs.teeth.empty()) return 0;
  std::vector<double> lengths;
  lengths.reserve(combs.teeth.size());
  for (const Vector3& tooth : combs.teeth) lengths.push_back(tooth.norm());
  const auto at = lengths.begin() + static_cast<std::ptrdiff_t>((lengths.size() - 1) * 19 / 20);
  std::nth_element(lengths.begin(), at, lengths.end());
  return *at;
}

}  // namespace hariko
