#pragma once

// EdgeSet: lookup of edges of a polyhedron in logarithmic time. A vertex may have any number of edges, so
// asking the polyhedron for each of many edges could take quadratic time.

#include <algorithm>
#include <vector>

#include "core/polyhedron/polyhedron.hpp"

namespace hariko::detail {

class EdgeSet {
 public:
  /// O(edges log edges).
  explicit EdgeSet(const Polyhedron& polyhedron) {
    edges_.reserve(polyhedron.edge_count());
    for (Index e = 0; e < polyhedron.edge_count(); ++e) edges_.push_back(polyhedron.edge_id(e));
    std::sort(edges_.begin(), edges_.end());
  }
  bool contains(EdgeId id) const { return std::binary_search(edges_.begin(), edges_.end(), id); }

 private:
  std::vector<EdgeId> edges_;
};

}  // namespace hariko::detail
