#pragma once

// Triangles of a fan joined to quads.

#include <functional>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Triangles between an apex on one row and two or more vertices in order on the next or the one before.
struct TriangleFan {
  Index apex = no_index;
  std::vector<Index> outer;
  bool apex_on_first_row = true;  ///< decides which way round the faces are
};

/// Faces of a fan, with neighbouring triangles joined pairwise: the edge from the apex to the vertex between
/// goes where `may_go(that vertex)`. An odd fan keeps one triangle: the middle one where that leaves pairs on
/// both sides, else the first or last, the one farther from the middle (`parameter` of an outer vertex, 1/2
/// in the middle of the section), so that mirror images share the rule.
std::vector<std::vector<Index>> fan_faces(const TriangleFan& fan, const std::function<bool(Index)>& may_go,
                                          const std::function<double(Index)>& parameter);

}  // namespace hariko
