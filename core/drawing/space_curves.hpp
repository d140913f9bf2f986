#pragma once

// Space curves of a drawing: contours of functions on a surface, seams and borders.

#include <vector>

#include "core/base/cancellation.hpp"
#include "core/drawing/surface_grid.hpp"

namespace hariko {

/// Curve on a surface. `away` has, for each point, a unit direction (or zero) that leads from the surface to
/// the side from which the curve is seen.
struct SpaceCurve {
  LineKind kind;
  std::vector<Vector3> points, away;
};

/// Silhouettes, where the normal is perpendicular to the view direction. O(triangles log triangles).
std::vector<SpaceCurve> silhouettes(const SurfaceGrid& grid, const DrawingView& view,
                                    const CancelToken& cancel);
/// Intersection of the surface with the view's section plane; empty without a section.
std::vector<SpaceCurve> section_lines(const SurfaceGrid& grid, const DrawingView& view,
                                      const CancelToken& cancel);
/// Borders, creases (seams that are only G0; parts where exactly one side faces the viewer are silhouettes)
/// and, if wanted, seams on edges of the source.
std::vector<SpaceCurve> seam_curves(const SurfaceGrid& grid, const DrawingView& view, bool network);

}  // namespace hariko
