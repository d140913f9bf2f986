#pragma once

// ElementSet: vertices, edges and faces of one polyhedron, by their stable ids.

#include <cstddef>
#include <set>

#include "core/base/ids.hpp"

namespace hariko {

struct ElementSet {
  std::set<VertexId> vertices;
  std::set<EdgeId> edges;
  std::set<FaceId> faces;

  bool empty() const { return vertices.empty() && edges.empty() && faces.empty(); }
  std::size_t size() const { return vertices.size() + edges.size() + faces.size(); }
  friend bool operator==(const ElementSet&, const ElementSet&) = default;
};

/// Returns the ids in ascending order, as most operations take them.
template <class Id>
std::vector<Id> list_of(const std::set<Id>& ids) {
  return {ids.begin(), ids.end()};
}

}  // namespace hariko
