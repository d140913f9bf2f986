#pragma once

// Drag region: the rings of faces around the moved vertices in which the response to a drag is solved, and
// the network's response there.

#include <vector>

#include "core/patching/surface_system.hpp"

namespace hariko {

/// Share of a displacement below which patches and faces are left out of a response.
inline constexpr double negligible_share = 1e-11;

/// Faces and vertices of a drag region.
struct Neighbourhood {
  std::vector<Index> faces, vertices;  ///< ascending
};

/// Faces and vertices within `rings` rings of faces around the given vertices; the influence of a vertex
/// fades by about 0.27 per ring.
Neighbourhood neighbourhood(const HalfEdgeMesh& mesh, const std::vector<Index>& moved, int rings);

/// Start of a response: the region, the displacement field and the network's response.
struct LocalDrag {
  Neighbourhood near;
  std::vector<Vector3> field;  ///< share of each vertex in a unit displacement along x; y and z stay zero
  Network network;             ///< tangents in response to it: zero outside the neighbourhood
};
/// Solves the network's response. Requires `!system.network.couples_coordinates()`.
LocalDrag local_drag(const SurfaceSystem& system, const std::vector<Index>& moved,
                     const std::vector<double>& weight, int rings, double tolerance);

}  // namespace hariko
