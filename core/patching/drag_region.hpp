#pragma once

// What a drag's response is solved in: the rings of faces round the vertices that move, and the network's
// answer there.

#include <vector>

#include "core/patching/surface_system.hpp"

namespace hariko {

struct Neighbourhood {
  std::vector<Index> faces, vertices;  ///< ascending
};

/// `rings` rings of faces round the vertices; the influence of a vertex fades by about 0.27 a ring.
Neighbourhood neighbourhood(const HalfEdgeMesh& mesh, const std::vector<Index>& moved, int rings);

/// Each vertex's share of a unit displacement along x; the other coordinates stay zero.
std::vector<Vector3> unit_displacement(const HalfEdgeMesh& mesh, const std::vector<Index>& moved,
                                       const std::vector<double>& weight);

/// Tangents that answer a displacement field: zero outside the neighbourhood.
Network local_network(const SurfaceSystem& system, const Neighbourhood& near, std::span<const Vector3> field,
                      double tolerance);

}  // namespace hariko
