#pragma once

// Repairs that validation offers. Each returns a new mesh and leaves positions of kept vertices alone.

#include "core/base/result.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Makes neighbouring faces agree in orientation (flood fill over edges shared by two faces), then turns
/// closed components outward (positive signed volume). Fails with E_EDGE_NONMANIFOLD_OR_FLIPPED where no
/// consistent orientation exists (a one-sided surface) or an edge has more than two faces.
Result<PolygonMesh> repair_orientation(const PolygonMesh& mesh);

/// Cuts the mesh open along edges with more than two faces, or used twice in one direction, by duplicating
/// vertices.
PolygonMesh split_nonmanifold_edges(const PolygonMesh& mesh);

/// Gives every fan at a vertex that has several its own copy of the vertex.
PolygonMesh split_nonmanifold_vertices(const PolygonMesh& mesh);

/// Removes vertices that no face uses.
PolygonMesh remove_isolated_vertices(const PolygonMesh& mesh);

/// Merges vertices closer than `distance` (in the mesh's unit, >= 0; 0 merges equal positions only). Faces
/// that lose corners shrink; those left with fewer than three are dropped.
PolygonMesh weld(const PolygonMesh& mesh, double distance);

}  // namespace hariko
