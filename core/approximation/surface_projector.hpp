#pragma once

// Closest point on a surface to a point in space.

#include "core/approximation/surface_sampler.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/geometry/triangle_tree.hpp"

namespace hariko {

/// Closest point on a surface.
struct SurfaceFoot {
  Index patch = 0;
  Vector2 parameter = Vector2::Zero();
  Vector3 position = Vector3::Zero();
  double distance = 0;
};

/// Closest point search. Starts from the triangles of a fine mesh of every patch and continues by Newton
/// steps on the patch itself. The result is always a point of the surface, so its distance is at least the
/// true one; it is larger only where another part of the surface is as near within the fine mesh's own error.
/// Keeps a reference to the sampler; thread-safe.
class SurfaceProjector {
 public:
  /// Prepares a mesh of about `triangles` triangles, at least two per patch; O(n log n).
  explicit SurfaceProjector(const SurfaceSampler& sampler, std::size_t triangles = 40'000);

  /// Closest point; positions are relative to the surface's origin.
  SurfaceFoot foot(const Vector3& point) const;
  /// Side of the fine mesh that a point is on, see `TriangleTree::side`: at edges, where closest points have
  /// several normals.
  double side(const Vector3& point) const { return tree_.side(point, tree_.nearest(point)); }

 private:
  struct Net;
  SurfaceProjector(const SurfaceSampler& sampler, const Net& net);

  const SurfaceSampler& sampler_;
  std::vector<std::array<int, 3>> pattern_;  ///< triangles of one patch
  std::vector<Vector2> parameters_;          ///< parameters of one patch's points
  std::vector<Vector3> points_;              ///< points of all patches
  TriangleTree tree_;
};

/// Largest distance found of a surface from `other`, at 15 points of each of its patches (square ones: 25).
/// O(patches log patches). Invalid when cancelled.
double farthest_from(const Surface& surface, const Surface& other, const CancelToken& cancel = {},
                     const Progress& progress = {});

}  // namespace hariko
