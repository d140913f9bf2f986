#pragma once

// Selection of elements similar to the selected ones.

#include "core/document/source.hpp"
#include "core/modeling/selection/element_set.hpp"

namespace hariko {

/// Criterion for vertices. `place`: inner vertices, vertices on a border. `sharp_edges`: the number of
/// creases and border edges.
enum class VertexLikeness { valence, tension, sharp_edges, place };
/// Criterion for edges. `fold`: the angle between the two faces. `place`: inner edges, border edges.
enum class EdgeLikeness { length, tension, crease, fold, place };
/// Criterion for faces. `normal`: direction of the mean plane. `plane`: direction and place of the mean
/// plane.
enum class FaceLikeness { side_count, area, normal, plane };

// Returns the elements similar to any of the given ones, which are included. Lengths, areas and tensions are
// similar when they differ by at most `tolerance` of the larger one, angles when they differ by at most
// `tolerance` half turns, planes when moreover their distance is at most `tolerance` of the size of the
// polyhedron. Ids that the polyhedron does not have are ignored. O(n log n), for directions O(n given).
std::set<VertexId> similar_vertices(const PolyhedronSource& source, const std::set<VertexId>& vertices,
                                    VertexLikeness likeness, double tolerance = 1e-6);
std::set<EdgeId> similar_edges(const PolyhedronSource& source, const std::set<EdgeId>& edges,
                               EdgeLikeness likeness, double tolerance = 1e-6);
std::set<FaceId> similar_faces(const PolyhedronSource& source, const std::set<FaceId>& faces,
                               FaceLikeness likeness, double tolerance = 1e-6);

}  // namespace hariko
