#pragma once

// Joining the triangles of a fan to quads.

#include <functional>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Fan of triangles between an apex on one row and two or more consecutive vertices on the next or the
/// previous row.
struct TriangleFan {
  Index apex = no_index;
  std::vector<Index> outer;
  bool apex_on_first_row = true;  ///< determines the orientation of the faces
};

/// Faces of a fan, with neighbouring triangles joined pairwise: the edge from the apex to the vertex between
/// them is removed where `may_go(that vertex)`. An odd fan keeps one triangle: the middle one where that
/// leaves pairs on both sides, else the first or last, the one farther from the middle (`parameter` of an
/// outer vertex, 1/2 in the middle of the section), so that mirror images are treated alike.
std::vector<std::vector<Index>> fan_faces(const TriangleFan& fan, const std::function<bool(Index)>& may_go,
                                          const std::function<double(Index)>& parameter);

}  // namespace hariko
