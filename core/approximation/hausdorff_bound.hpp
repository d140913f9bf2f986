#pragma once

// Certain bound of the distance of one mesh's triangles from another mesh.

#include <optional>
#include <span>

#include "core/base/cancellation.hpp"
#include "core/geometry/triangle_tree.hpp"

namespace hariko {

/// Result of `bounded_distance`.
struct MeshBound {
  /// Upper bound of the distance of any point of any triangle; nothing where a triangle is, or might be,
  /// farther than the tolerance.
  std::optional<double> bound;
  Index triangle = no_index;  ///< the first triangle that is not within the tolerance
};

/// Computes the bound. The distance to one triangle is convex, so the largest at a piece's corners bounds
/// that of the whole piece. Pieces whose corners are nearest to different triangles are cut by the bisecting
/// plane of the two, or halved, until one triangle is near enough to all of their corners. `tree` is over the
/// other mesh, whose triangles are `others`. Work per triangle is bounded. The same result on any number of
/// threads.
MeshBound bounded_distance(std::span<const Vector3> positions,
                           std::span<const std::array<Index, 3>> triangles, const TriangleTree& tree,
                           std::span<const Vector3> other_positions,
                           std::span<const std::array<Index, 3>> others, double tolerance,
                           const CancelToken& cancel = {});

}  // namespace hariko
