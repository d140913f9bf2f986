#pragma once

// Edge loops and edge rings: the two sequences of edges that continue an edge over a polyhedron.

#include <vector>

#include "core/base/ids.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Edges in line with an edge, in order: straight on through inner vertices of four edges, to the other edge
/// at inner vertices of two, and from an open edge along its border. The loop stops at any other vertex.
/// Includes the edge itself; empty when the polyhedron has no such edge. O(length).
std::vector<EdgeId> edge_loop(const Polyhedron& polyhedron, EdgeId edge);

/// Edges side by side with an edge, in order: each is the opposite edge in a quad. The ring stops at faces
/// that are not quads and at borders. Includes the edge itself; empty when the polyhedron has no such edge.
/// O(length).
std::vector<EdgeId> edge_ring(const Polyhedron& polyhedron, EdgeId edge);

/// An edge ring by dense indices.
struct EdgeRing {
  std::vector<Index> edges;
  /// Per edge, the vertex at which it starts; all starts lie on the same side of the ring.
  std::vector<Index> starts;
  bool closed = false;
};
/// Edge ring of the edge with this dense index (see `edge_ring`). O(length).
EdgeRing find_edge_ring(const Polyhedron& polyhedron, Index edge);

}  // namespace hariko
