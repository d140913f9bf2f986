#pragma once

// A certain bound of how far the triangles of one mesh are from another mesh.

#include <optional>
#include <span>

#include "core/base/cancellation.hpp"
#include "core/geometry/triangle_tree.hpp"

namespace hariko {

struct MeshBound {
  /// No point of any triangle is farther than this; nothing where a triangle is, or might be, farther than
  /// the tolerance.
  std::optional<double> bound;
  Index triangle = no_index;  ///< the first that is not within the tolerance
};

/// The distance to one triangle is convex, so that of a piece's corners bounds that of the whole piece.
/// Pieces whose corners are nearest to different triangles are cut by the plane between the two, or halved,
/// until one triangle is near enough to all of their corners. `tree` is over the other mesh, whose triangles
/// are `others`. Work for one triangle is bounded. The same on any number of threads.
MeshBound bounded_distance(std::span<const Vector3> positions,
                           std::span<const std::array<Index, 3>> triangles, const TriangleTree& tree,
                           std::span<const Vector3> other_positions,
                           std::span<const std::array<Index, 3>> others, double tolerance,
                           const CancelToken& cancel = {});

}  // namespace hariko
