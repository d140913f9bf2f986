#pragma once

// Edge loops and edge rings: the two ways a designer follows an edge over a polyhedron.

#include <vector>

#include "core/base/ids.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// The edges in line with an edge, in order: through inner vertices of four edges straight on, through those
/// of two to the other one; an open edge leads all along its border. It stops elsewhere. The edge itself is
/// among them; empty when the polyhedron has no such edge. O(length).
std::vector<EdgeId> edge_loop(const Polyhedron& polyhedron, EdgeId edge);

/// The edges side by side with an edge, in order: each the opposite one in a quad. It stops at faces that are
/// no quads and at borders. The edge itself is among them; empty when the polyhedron has no such edge.
/// O(length).
std::vector<EdgeId> edge_ring(const Polyhedron& polyhedron, EdgeId edge);

/// An edge ring by dense indices.
struct EdgeRing {
  std::vector<Index> edges;
  /// Per edge the vertex at which it starts, all on the same side of the ring.
  std::vector<Index> starts;
  bool closed = false;
};
EdgeRing find_edge_ring(const Polyhedron& polyhedron, Index edge);

}  // namespace hariko
