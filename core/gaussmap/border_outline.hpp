#pragma once

// The border of a surface as an outline, for another surface that goes on from there.

#include "core/gaussmap/outline_settings.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

inline constexpr Code e_no_border{"E_NO_BORDER"};

/// On which side of the border the outline's surface is to lie.
enum class BorderSide {
  beyond,  ///< across the border: it closes a hole, or goes on where the surface ends
  same     ///< where the surface is: it replaces that
};

/// All borders of the surface, each a loop: at least `least_points` points a loop, as many on each side of a
/// patch, corners among them; with the surface's normals and Gaussian curvature there. A corner of patches,
/// where that differs from patch to patch, has the mean of both sides' next points. Loops begin at their
/// lowest patch. The outline has no curvature where the surface has none at some point. Errors: E_NO_BORDER
/// (a closed surface; a border that does not come round). O(border points).
Result<Outline> border_outline(const Surface& surface, BorderSide side, std::size_t least_points = 24);

struct BorderFill {
  Outline outline;
  OutlineSettings settings;
};
/// One loop of a border with the settings that fill it most likely: those of a dome where its tangent planes
/// cut off none of its points, of a saddle where all of its curvature is negative, else the mode position.
/// The curvature is kept where it has the sign of that shape: patches bend across their border as the faces
/// beyond do not hold them, so that on a sphere's border it may be negative. O(points^2).
BorderFill border_fill(OutlineLoop loop);

}  // namespace hariko
