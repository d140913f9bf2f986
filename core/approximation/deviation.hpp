#pragma once

// Deviation: the signed distance of points and surfaces from a reference surface.

#include <memory>
#include <span>

#include "core/approximation/surface_projector.hpp"
#include "core/geometry/triangle_tree.hpp"

namespace hariko {

/// Surface that others are compared with. Immutable; all queries are thread-safe.
class DeviationReference {
 public:
  enum class Kind {
    smooth,  ///< closest points on the patches themselves
    facets,  ///< flat triangles, whose distance is exact
  };
  /// Prepares the search. `surface` has patches (asserted). O(n log n).
  DeviationReference(Surface surface, Kind kind);
  DeviationReference(const DeviationReference&) = delete;
  DeviationReference& operator=(const DeviationReference&) = delete;

  const Surface& surface() const { return surface_; }
  Kind kind() const { return kind_; }
  /// Distance of a point, relative to the surface's origin, to the nearest point of the surface: positive on
  /// the side that the surface's normal points to. At sharp edges the side is that of the face whose plane is
  /// farther away. O(log n).
  double signed_distance(const Vector3& point) const;

 private:
  double smooth_distance(const Vector3& point) const;

  Surface surface_;
  Kind kind_;
  SurfaceSampler sampler_;                           ///< samples `surface_`
  std::unique_ptr<const SurfaceProjector> feet_;     ///< for smooth surfaces
  std::unique_ptr<const TriangleTree> facets_tree_;  ///< for facets
};

/// Map from a surface's positions, relative to its origin, to those of a reference, relative to its own:
/// p becomes turn * p + shift.
struct ToReference {
  Matrix3 turn = Matrix3::Identity();  ///< a rotation times a factor
  Vector3 shift = Vector3::Zero();
};

/// Signed distances of a surface from the reference, times `scale`, the length in the world of a unit of the
/// reference: values[k * n + i] for grid point i of patches[k], n = pattern.point_count(). Thread-safe; runs
/// on the calling thread. O(values log n).
void deviation_values(const Surface& surface, const DeviationReference& reference, const ToReference& place,
                      double scale, std::span<const Index> patches, const GridPattern& pattern,
                      std::span<float> values);

}  // namespace hariko
