#pragma once

// Borders of a polyhedron as vertex cycles in the direction of new faces along them.

#include <span>
#include <vector>

#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Returns the vertices of a border in the order of a face that would close it, which is against the border
/// half-edges. `edge` must be a border edge. O(border + valences).
std::vector<Index> border_loop(const HalfEdgeMesh& mesh, Index edge);

/// Border edges joined end to end.
struct BorderChain {
  std::vector<Index> vertices;  ///< in the direction of a new face; each vertex once if closed
  bool closed = false;
};

/// Joins border edges end to end; returns open chains first, then ordered by their lowest vertex. All edges
/// must be border edges.
std::vector<BorderChain> border_chains(const HalfEdgeMesh& mesh, std::span<const Index> edges);

}  // namespace hariko
