#pragma once

// Connected sets of faces, and spline faces beside faces of other kinds. Private to this folder.

#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Sets of faces connected over common edges, numbered from 0.
struct ConnectedFaces {
  std::vector<Index> set_of_face;  ///< by face, in the explorer's order
  std::vector<bool> closed;        ///< by set: no edge has a face on one side only
  /// By face, in the explorer's order: number of the solid that it bounds, no_index where it is in none.
  std::vector<Index> solid_of_face;
};
/// Connected sets of the faces of a shape. O(faces + edges).
ConnectedFaces connected_faces(const TopoDS_Shape& shape);

/// Marks each face whose set contains a face that is not `whole` (one flag a face). All faces of such a set
/// are triangulated together, so that they share the points along their edges.
std::vector<bool> beside_others(const ConnectedFaces& faces, const std::vector<bool>& whole);

}  // namespace hariko
