#pragma once

// Faces of a shape that hang together, and spline faces beside others. Only for this folder.

#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/base/ids.hpp"

namespace hariko {

/// Sets of faces that hang together over common edges, numbered from 0.
struct ConnectedFaces {
  std::vector<Index> set_of_face;  ///< of each face, in the explorer's order
  std::vector<bool> closed;        ///< of each set: no edge of it has a face on one side only
};
ConnectedFaces connected_faces(const TopoDS_Shape& shape);

/// Tells of each face whether one of its set is not `whole` (one flag a face). Such faces become triangles
/// together, so that they share the points along their edges.
std::vector<bool> beside_others(const ConnectedFaces& faces, const std::vector<bool>& whole);

}  // namespace hariko
