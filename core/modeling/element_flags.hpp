#pragma once

// ElementFlags: a set of elements as one mark for each dense element, which queries walk quickly.

#include <vector>

#include "core/modeling/element_set.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

struct ElementFlags {
  std::vector<char> vertices, edges, faces;

  /// No element marked.
  explicit ElementFlags(const Polyhedron& polyhedron);
  /// Ids that the polyhedron does not have are left out. O(elements log set).
  ElementFlags(const Polyhedron& polyhedron, const ElementSet& set);

  ElementSet to_set(const Polyhedron& polyhedron) const;
};

/// One mark a face; ids that the polyhedron does not have are left out.
std::vector<char> face_flags(const Polyhedron& polyhedron, const std::set<FaceId>& faces);

}  // namespace hariko
