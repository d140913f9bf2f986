#pragma once

// Maps of making: whether a part leaves its mould, whether a tool fits, and how thick a wall is. Values as in
// `map_values`: values[k * n + i] for grid point i of patches[k], n = pattern.point_count(). All functions
// are thread-safe and run on the calling thread; the values do not depend on how patches are grouped.

#include <span>

#include "core/geometry/triangle_tree.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Draft angle, degrees, -90 .. 90: between the surface and the direction `pull` in which a part leaves its
/// mould, 90 less the angle between normal and pull. Negative where the part cannot leave: where the surface
/// faces away from the pull, and where something in `hiding` lies in the way; the angle is then the same with
/// a minus, at least 0.05. Within 0.05 of upright it is 0. `pull`: in the surface's axes, of any length but
/// 0. `hiding`: triangles of the surface relative to its origin, at which a ray along the pull may enter
/// again; null looks at the signs alone. NaN where there is no normal. O(values), with `hiding` O(values log
/// triangles).
void draft_values(const Surface& surface, const Vector3& pull, const TriangleTree* hiding,
                  std::span<const Index> patches, const GridPattern& pattern, std::span<float> values);

/// Smallest radius of curvature, 1 / max(|k1|, |k2|), times `scale`: the largest ball that rolls over the
/// point on the side that it is bent to. Infinite where the surface is flat, to an arrow of a hundred
/// millionth of its patch. NaN where the curvature is undefined; at corners as in `map_values`. O(values).
void radius_values(const Surface& surface, double scale, std::span<const Index> patches,
                   const GridPattern& pattern, std::span<float> values);

/// Thickness of the wall of a closed surface, times `scale`: the distance along the inward normal to where
/// the ray leaves the body. `walls`: triangles of the same surface relative to its origin; the result is as
/// exact as they are. 0 at acute edges, where the ray leaves at once. NaN where there is no normal, and where
/// the ray never leaves, as on a surface that is not closed or looks inward. O(values log triangles).
void thickness_values(const Surface& surface, const TriangleTree& walls, double scale,
                      std::span<const Index> patches, const GridPattern& pattern, std::span<float> values);

}  // namespace hariko
