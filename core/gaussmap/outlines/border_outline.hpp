#pragma once

// Outlines from the border of a surface, for another surface that continues from there.

#include "core/gaussmap/outlines/outline_settings.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

inline constexpr Code e_no_border{"E_NO_BORDER"};

/// Side of the border on which the outline's surface lies.
enum class BorderSide {
  beyond,  ///< across the border: closes a hole, or continues where the surface ends
  same     ///< on the side of the surface, which it replaces
};

/// Outlines of all borders of the surface, one loop each: at least `least_points` points per loop, equally
/// many on each side of a patch, corners included; with the surface's normals and Gaussian curvature there.
/// At a corner of patches, where the curvature differs from patch to patch, it is the mean of the next points
/// on both sides. Loops begin at their lowest patch. The outline has no curvature if the surface has none, or
/// exactly zero, at some point. Errors: E_NO_BORDER (a closed surface; a border that does not form a loop).
/// O(border points).
Result<Outline> border_outline(const Surface& surface, BorderSide side, std::size_t least_points = 24);

/// Outline of a border with settings for its fill.
struct BorderFill {
  Outline outline;
  OutlineSettings settings;
};
/// Returns one loop of a border with the most likely settings of its fill: those of a dome where all its
/// points lie on one side of its tangent planes, of a saddle where all of its curvature is negative, else
/// mode position. The curvature is kept where it has the sign of that shape: patches bend across their
/// border, where no neighbouring faces hold them, so that on a sphere's border it may be negative.
/// O(points^2).
BorderFill border_fill(OutlineLoop loop);

}  // namespace hariko
