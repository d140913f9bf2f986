#pragma once

// The curves of a drawing in space: contours of functions on a surface, and its seams and borders.

#include <functional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/drawing/surface_grid.hpp"

namespace hariko {

/// A curve on a surface, with the direction at each point that leads away from the surface to where it is
/// seen from (unit or zero).
struct SpaceCurve {
  LineKind kind;
  std::vector<Vector3> points, away;
};

/// Where the surface turns from the viewer.
std::vector<SpaceCurve> silhouettes(const SurfaceGrid& grid, const DrawingView& view,
                                    const CancelToken& cancel);
/// Where the view's section cuts the surface; none without a section.
std::vector<SpaceCurve> section_lines(const SurfaceGrid& grid, const DrawingView& view,
                                      const CancelToken& cancel);
/// Borders, creases (seams that are no more than G0; where one side alone faces the viewer they are
/// silhouettes) and, if wanted, seams that lie on edges of the source.
std::vector<SpaceCurve> seam_curves(const SurfaceGrid& grid, const DrawingView& view, bool network);

}  // namespace hariko
