#pragma once

// CornerFans: the fans of corners around the vertices of a mesh that need not be manifold.

#include <vector>

#include "core/base/vector.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Corner fans: two corners of a vertex are in the same fan when faces joined by manifold edges
/// (is_manifold_edge) connect them.
struct CornerFans {
  /// Per corner: number of its fan at its vertex, from 0; no_index in unsound faces.
  std::vector<Index> fan;
  std::vector<Index> fan_count;       ///< per vertex
  std::vector<char> at_faulty_edge;   ///< per vertex: 1 when one of its edges is not manifold
  std::vector<char> at_unsound_face;  ///< per vertex: 1 when a face with a fault of its own uses it
};

/// Corner at the other side of the edge that each corner starts, for manifold edges; no_index at borders and
/// at faulty edges. O(corners).
std::vector<Index> find_twins(const PolygonMesh& mesh, const EdgeTable& edges);

/// Finds the fans. `sound` comes from sound_faces, `edges` are those of the sound faces. O(corners).
CornerFans find_corner_fans(const PolygonMesh& mesh, const std::vector<char>& sound, const EdgeTable& edges);

/// The same for given pairs of corners (`twin`, no_index for none) instead of those at manifold edges.
CornerFans find_corner_fans(const PolygonMesh& mesh, const std::vector<char>& sound, const EdgeTable& edges,
                            const std::vector<Index>& twin);

}  // namespace hariko
