#pragma once

// The point of a surface that is nearest to a point in space.

#include "core/approximation/surface_sampler.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/geometry/triangle_tree.hpp"

namespace hariko {

struct SurfaceFoot {
  Index patch = 0;
  Vector2 parameter = Vector2::Zero();
  Vector3 position = Vector3::Zero();
  double distance = 0;
};

/// Looks among the triangles of a fine mesh of every patch first and goes on from there on the patch itself.
/// A foot is always a point of the surface, so that its distance is at least the true one; it is larger only
/// where another part of the surface is as near to within the fine mesh's own error. Borrows the sampler;
/// thread-safe.
class SurfaceFeet {
 public:
  /// With about `triangles` triangles, at least two a patch; O(n log n).
  explicit SurfaceFeet(const SurfaceSampler& sampler, std::size_t triangles = 40'000);

  /// Positions are relative to the surface's origin.
  SurfaceFoot foot(const Vector3& point) const;

 private:
  struct Net;
  SurfaceFeet(const SurfaceSampler& sampler, const Net& net);

  const SurfaceSampler& sampler_;
  std::vector<std::array<int, 3>> pattern_;  ///< triangles of one patch
  std::vector<Vector2> parameters_;          ///< of one patch
  std::vector<Vector3> points_;              ///< of all patches
  TriangleTree tree_;
};

/// Largest distance that a surface was found to have from `other`, at 15 points of each of its patches
/// (square ones: 25). O(patches log patches). Not to be used when cancelled.
double farthest_from(const Surface& surface, const Surface& other, const CancelToken& cancel = {},
                     const Progress& progress = {});

}  // namespace hariko
