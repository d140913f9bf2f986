#pragma once

// Faces that are whole splines, as Bezier patches. Private to this folder.

#include <TopoDS_Face.hxx>
#include <vector>

#include "core/surface/bezier_patch.hpp"

namespace hariko {

/// Exact Bezier patches of a face that is a whole spline; none where its surface is of another kind or of too
/// high a degree, or where its border does not run along the sides of a parameter rectangle.
std::vector<BezierPatch> whole_spline(const TopoDS_Face& face);

}  // namespace hariko
