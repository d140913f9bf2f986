#pragma once

// What of a curve in space may be seen on the page.

#include <vector>

#include "core/drawing/space_curves.hpp"

namespace hariko {

/// The parts of a curve that lie before the near plane, on the page or within `page_margin` of it and, but
/// for the lines of the section itself, on the side of the section that is kept. A curve of which nothing is
/// cut off stays as it is. O(points).
std::vector<SpaceCurve> clipped(const SpaceCurve& curve, const DrawingView& view);

/// Rounding in depth at this point, so that what touches is not taken for what hides. Length.
double depth_rounding(const DrawingView& view, const Vector3& point);

}  // namespace hariko
