#pragma once

// ElementFlags: a set of elements as one flag per dense element, for fast iteration.

#include <vector>

#include "core/modeling/selection/element_set.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Flags by dense index: nonzero means that the element is in the set.
struct ElementFlags {
  std::vector<char> vertices, edges, faces;

  /// Empty set.
  explicit ElementFlags(const Polyhedron& polyhedron);
  /// Set of the given elements. Ids that the polyhedron does not have are ignored. O(elements log set).
  ElementFlags(const Polyhedron& polyhedron, const ElementSet& set);

  /// Returns the marked elements by their stable ids. O(elements log set).
  ElementSet to_set(const Polyhedron& polyhedron) const;
};

/// Returns one flag per face; ids that the polyhedron does not have are ignored.
std::vector<char> face_flags(const Polyhedron& polyhedron, const std::set<FaceId>& faces);

}  // namespace hariko
