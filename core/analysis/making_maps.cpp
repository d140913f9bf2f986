#include "core/analysis/making_maps.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/analysis/maps.hpp"
#include "core/base/assert.hpp"
#include "core/geometry/angles.hpp"

namespace hariko {

namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();
/// Distance from a surface, relative to its size, below which a ray is still at the surface itself.
constexpr double at_itself = 1e-6;
/// Draft, degrees, below which a wall is upright: about what patches round upright walls of solids waver by,
/// which must not speckle them with undercuts. 0.09 mm over a wall of 100 mm.
constexpr double upright = 0.05;
/// Draft, degrees, of hidden places whose walls are upright.
constexpr double least_hidden = 0.05;
/// Curvature times the size of the patch below which a patch is flat.
constexpr double flatness = 1e-7;

/// Sets values[k * n + i] = value(position, normal) at every grid point that has a normal, NaN elsewhere.
template <class Value>
void for_points(const Surface& surface, std::span<const Index> patches, const GridPattern& pattern,
                std::span<float> values, const Value& value) {
  const auto count = static_cast<std::size_t>(pattern.point_count());
  HARIKO_ASSERT(values.size() == count * patches.size(), "one value a point");
  const std::vector<Vector2> parameters = pattern.parameters();
  std::vector<Vector3> positions(count), normals(count);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    surface.patches().evaluate_grid(patches.subspan(k, 1), pattern, positions, normals);
    for (std::size_t i = 0; i < count; ++i) {
      Vector3 normal = normals[i];
      // As the picture has it: where derivatives are parallel, the node knows the normal.
      if (!(normal.squaredNorm() > 0.25)) normal = surface.normal(patches[k], parameters[i]);
      values[k * count + i] = normal.isZero(0) ? no_value : static_cast<float>(value(positions[i], normal));
    }
  }
}

}  // namespace

void draft_values(const Surface& surface, const Vector3& pull, const TriangleTree* hiding,
                  std::span<const Index> patches, const GridPattern& pattern, std::span<float> values) {
  HARIKO_ASSERT(pull.squaredNorm() > 0, "a pull has a direction");
  const Vector3 along = pull.normalized();
  const double step = hiding ? at_itself * hiding->size() : 0;
  for_points(surface, patches, pattern, values, [&](const Vector3& position, const Vector3& normal) {
    double draft = 90 - angle_between(normal, along) * 180 / std::numbers::pi;
    if (std::abs(draft) < upright) draft = 0;
    if (draft < 0 || !hiding) return draft;
    const double way =
        hiding->first_crossing(position + step * normal, along, TriangleTree::Crossing::entering, step);
    return std::isfinite(way) ? -std::max(draft, least_hidden) : draft;
  });
}

void radius_values(const Surface& surface, double scale, std::span<const Index> patches,
                   const GridPattern& pattern, std::span<float> values) {
  map_values(surface, MapKind::largest, patches, pattern, values);
  const auto count = static_cast<std::size_t>(pattern.point_count());
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const double flat = flatness / std::max(surface.patch_scale(patches[k]), 1e-300);
    for (float& value : values.subspan(k * count, count)) {
      if (std::isnan(value)) continue;
      value = double(value) < flat ? std::numeric_limits<float>::infinity()
                                   : static_cast<float>(scale / double(value));
    }
  }
}

void thickness_values(const Surface& surface, const TriangleTree& walls, double scale,
                      std::span<const Index> patches, const GridPattern& pattern, std::span<float> values) {
  for_points(surface, patches, pattern, values, [&](const Vector3& position, const Vector3& normal) {
    // Triangles between points of a bent surface may lie a little before the point itself.
    const double way =
        walls.first_crossing(position, -normal, TriangleTree::Crossing::leaving, -at_itself * walls.size());
    return std::isfinite(way) ? scale * std::max(way, 0.0) : double(no_value);
  });
}

}  // namespace hariko
