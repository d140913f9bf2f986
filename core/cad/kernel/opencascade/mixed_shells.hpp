#pragma once

// Spline faces beside others. Only for this folder.

#include <TopoDS_Shape.hxx>
#include <vector>

namespace hariko {

/// Tells of each face of a shape, in the explorer's order, whether it hangs together, over common edges, with
/// a face that is not `whole` (one flag a face, in the same order). Such faces become triangles together, so
/// that they share the points along their edges.
std::vector<bool> beside_others(const TopoDS_Shape& shape, const std::vector<bool>& whole);

}  // namespace hariko
