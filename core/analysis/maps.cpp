#include "core/analysis/maps.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/curvature.hpp"
#include "core/base/assert.hpp"

namespace hariko {

namespace {

constexpr float undefined = std::numeric_limits<float>::quiet_NaN();

double pick(const Curvature& at, MapKind kind) {
  switch (kind) {
    case MapKind::gauss:
      return at.gauss;
    case MapKind::mean:
      return at.mean;
    case MapKind::k1:
      return at.k1;
    case MapKind::k2:
      return at.k2;
    case MapKind::largest:
      return std::max(std::abs(at.k1), std::abs(at.k2));
  }
  return 0;
}

/// Distance from the corner, in the patch's parameters, at which limits are evaluated where second
/// derivatives depend on the direction: curvature differs from its limit by about as much, and rounding is
/// still far below.
constexpr double limit_distance = 1e-3;

/// Limit of a map at a corner: the mean of the limits along both sides and between them; undefined where none
/// of them is defined.
float mean_limit(const Surface& surface, MapKind kind, Index patch, int corner) {
  const int sides = corner_count(surface.domain());
  const Vector2 along_next = side_parameter(surface.domain(), corner, limit_distance);
  const Vector2 along_last =
      side_parameter(surface.domain(), (corner + sides - 1) % sides, 1 - limit_distance);
  double sum = 0;
  int defined = 0;
  for (const Vector2& parameter : {along_next, along_last, Vector2((along_next + along_last) / 2)})
    if (const auto at = curvature(surface.patches().evaluate(patch, parameter, Order::second))) {
      sum += pick(*at, kind);
      ++defined;
    }
  return defined > 0 ? static_cast<float>(sum / defined) : undefined;
}

/// Sets values[i] = body(point on the first side, point on the second side) at density + 1 places of a seam.
template <class Body>
void along(const Surface& surface, Index seam_index, int density, std::span<float> values, const Body& body) {
  HARIKO_ASSERT(seam_index < surface.seams().size(), "no such seam");
  HARIKO_ASSERT(density >= 1 && values.size() == std::size_t(density) + 1, "one value a point");
  const Seam& seam = surface.seams()[seam_index];
  const auto at = [&](PatchSide side, double begin, double end, double x) {
    const Vector2 parameter = side_parameter(surface.domain(), side.side, begin + x * (end - begin));
    return surface.patches().evaluate(side.patch, parameter, Order::second);
  };
  for (int i = 0; i <= density; ++i) {
    // Along the seam itself curvature has a limit at both ends, even where it has none in other directions.
    const double x = std::clamp(grid_fraction(i, density), limit_distance, 1 - limit_distance);
    values[static_cast<std::size_t>(i)] = body(at(seam.first, seam.first_begin, seam.first_end, x),
                                               at(seam.second, seam.second_begin, seam.second_end, x));
  }
}

}  // namespace

void map_values(const Surface& surface, MapKind kind, std::span<const Index> patches,
                const GridPattern& pattern, std::span<float> values) {
  const auto count = static_cast<std::size_t>(pattern.point_count());
  HARIKO_ASSERT(values.size() == count * patches.size(), "one value a point");
  std::vector<PatchPoint> points(count);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    surface.patches().evaluate_grid(patches.subspan(k, 1), pattern, points);
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = curvature(points[i]);
      values[k * count + i] = at ? static_cast<float>(pick(*at, kind)) : undefined;
    }
    for (int c = 0; c < corner_count(pattern.domain); ++c) {
      const CornerSecondOrder order = surface.patches().second_order_at_corner(patches[k], c);
      if (order == CornerSecondOrder::exact) continue;
      values[k * count + static_cast<std::size_t>(pattern.side(c)[0])] =
          order == CornerSecondOrder::direction_dependent ? mean_limit(surface, kind, patches[k], c)
                                                          : undefined;
    }
  }
}

std::vector<float> map_values(const Surface& surface, MapKind kind, const GridPattern& pattern,
                              std::span<const Index> patches) {
  std::vector<float> values(static_cast<std::size_t>(pattern.point_count()) * patches.size());
  map_values(surface, kind, patches, pattern, values);
  return values;
}

void seam_curvature_jumps(const Surface& surface, Index seam, int density, std::span<float> values) {
  along(surface, seam, density, values, [](const PatchPoint& p, const PatchPoint& q) {
    const auto a = curvature(p), b = curvature(q);
    if (!a || !b) return undefined;
    const double mean = (a->tensor.norm() + b->tensor.norm()) / 2;
    return mean > 0 ? static_cast<float>((a->tensor - b->tensor).norm() / mean) : undefined;
  });
  const Seam& sides = surface.seams()[seam];
  const auto undefined_at = [&](PatchSide side, double fraction) {
    if (fraction != 0 && fraction != 1) return false;
    const int corner = (side.side + (fraction == 1 ? 1 : 0)) % corner_count(surface.domain());
    return surface.patches().second_order_at_corner(side.patch, corner) == CornerSecondOrder::undefined;
  };
  if (undefined_at(sides.first, sides.first_begin) || undefined_at(sides.second, sides.second_begin))
    values.front() = undefined;
  if (undefined_at(sides.first, sides.first_end) || undefined_at(sides.second, sides.second_end))
    values.back() = undefined;
}

}  // namespace hariko
