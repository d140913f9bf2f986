#pragma once

// What a drag's response is solved in: the rings of faces round the vertices that move, and the network's
// answer there.

#include <vector>

#include "core/patching/surface_system.hpp"

namespace hariko {

/// Patches and faces that feel less of a displacement than this share are not kept in a response.
inline constexpr double negligible_share = 1e-11;

struct Neighbourhood {
  std::vector<Index> faces, vertices;  ///< ascending
};

/// `rings` rings of faces round the vertices; the influence of a vertex fades by about 0.27 a ring.
Neighbourhood neighbourhood(const HalfEdgeMesh& mesh, const std::vector<Index>& moved, int rings);

/// What a response starts from.
struct LocalDrag {
  Neighbourhood near;
  std::vector<Vector3> field;  ///< each vertex's share of a unit displacement along x; y and z stay zero
  Network network;             ///< tangents that answer it: zero outside the neighbourhood
};
/// Requires `!system.network.couples_coordinates()`.
LocalDrag local_drag(const SurfaceSystem& system, const std::vector<Index>& moved,
                     const std::vector<double>& weight, int rings, double tolerance);

}  // namespace hariko
