#pragma once

// The borders of a polyhedron as the cycles that new faces along them would run.

#include <span>
#include <vector>

#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Vertices in the order in which a face that closes the border passes them: against the border half-edges.
/// `edge` must be a border edge. O(border + valences).
std::vector<Index> border_loop(const HalfEdgeMesh& mesh, Index edge);

struct BorderChain {
  std::vector<Index> vertices;  ///< in the direction of a new face; of a closed one each vertex once
  bool closed = false;
};

/// Border edges joined end to end, open ones first, then by their lowest vertex. All edges must be border
/// edges.
std::vector<BorderChain> border_chains(const HalfEdgeMesh& mesh, std::span<const Index> edges);

}  // namespace hariko
