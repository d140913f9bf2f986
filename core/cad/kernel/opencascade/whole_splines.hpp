#pragma once

// Faces that are whole splines, as Bezier patches. Only for this folder.

#include <TopoDS_Face.hxx>
#include <vector>

#include "core/surface/bezier_patch.hpp"

namespace hariko {

/// The face's spline in its Bezier pieces, which are exact; none where its surface is something else, of too
/// high a degree, or where its border does not run along the sides of a rectangle of parameters.
std::vector<BezierPatch> whole_spline(const TopoDS_Face& face);

}  // namespace hariko
