#include "core/approximation/deviation.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "core/base/assert.hpp"
#include "core/surface/surface_triangles.hpp"

namespace hariko {

namespace {

/// Cosine between the normal and the way to the closest point below which the closest point lies on an edge
/// or border, where the normal of one side says little.
constexpr double at_right_angles = 0.5;

}  // namespace

DeviationReference::DeviationReference(Surface surface, Kind kind)
    : surface_(std::move(surface)), kind_(kind), sampler_(surface_) {
  HARIKO_ASSERT(surface_.patch_count() > 0, "a reference has patches");
  if (kind_ == Kind::facets) {
    const SurfaceTriangles flat = surface_triangles(surface_, 1);
    facets_tree_ = std::make_unique<const TriangleTree>(flat.positions, flat.triangles);
  } else {
    feet_ = std::make_unique<const SurfaceProjector>(sampler_);
  }
}

double DeviationReference::signed_distance(const Vector3& point) const {
  if (kind_ == Kind::smooth) return smooth_distance(point);
  const TriangleTree::Nearest nearest = facets_tree_->nearest(point);
  return facets_tree_->side(point, nearest) * nearest.distance;
}

double DeviationReference::smooth_distance(const Vector3& point) const {
  const SurfaceFoot foot = feet_->foot(point);
  if (foot.distance == 0) return 0;
  const double cosine =
      sampler_.normal(foot.patch, foot.parameter).dot(point - foot.position) / foot.distance;
  const double side = std::abs(cosine) > at_right_angles ? cosine : feet_->side(point);
  return side < 0 ? -foot.distance : foot.distance;
}

void deviation_values(const Surface& surface, const DeviationReference& reference, const ToReference& place,
                      double scale, std::span<const Index> patches, const GridPattern& pattern,
                      std::span<float> values) {
  const auto count = static_cast<std::size_t>(pattern.point_count());
  HARIKO_ASSERT(values.size() == count * patches.size(), "one value a point");
  std::vector<Vector3> positions(count), normals(count);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    surface.patches().evaluate_grid(patches.subspan(k, 1), pattern, positions, normals);
    for (std::size_t i = 0; i < count; ++i)
      values[k * count + i] =
          static_cast<float>(scale * reference.signed_distance(place.turn * positions[i] + place.shift));
  }
}

}  // namespace hariko
