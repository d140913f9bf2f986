#pragma once

// Clipping of space curves to the view: near plane, page and section.

#include <vector>

#include "core/drawing/space_curves.hpp"

namespace hariko {

/// Parts of a curve beyond the near plane, on the page or within `page_margin` of it and, except for the
/// section's own lines, on the kept side of the section. A curve that nothing clips is returned unchanged.
/// O(points).
std::vector<SpaceCurve> clipped(const SpaceCurve& curve, const DrawingView& view);

/// Depth tolerance at a point, a length: what lies nearer by no more than this touches and does not hide.
double depth_rounding(const DrawingView& view, const Vector3& point);

}  // namespace hariko
