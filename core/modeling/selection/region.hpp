#pragma once

// Regions of selected faces, and detaching them from their surroundings with walls in the gap; shared by
// extruding and insetting.

#include <vector>

#include "core/modeling/mesh_editor.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Grouping of faces into the pieces that an operation treats as one: faces joined by edges, or every face by
/// itself.
enum class Grouping { region, individual };

/// Place where the rim of a region passes a vertex. With the region on the left the rim arrives along
/// half-edge `in` and leaves along `out`; both belong to faces of the region. A rim may pass a vertex several
/// times.
struct RimPoint {
  Index vertex;
  VertexId base;  ///< vertex that stays with the surroundings
  VertexId top;   ///< the region's own copy, at the same place
  Index in, out;
  std::vector<Index> inner_edges;  ///< edges between faces of the region that end here
};

/// One connected group of faces and its rim.
struct Region {
  std::vector<Index> faces;
  std::vector<RimPoint> rim;
  std::vector<Index> inner_vertices;  ///< vertices with faces of this region only, not on a border
  bool whole_part = false;            ///< the region is a whole connected part of the polyhedron
};

/// Groups the faces (dense, ascending) and finds their rims; `top` is still unset. O(corners of the mesh).
std::vector<Region> find_regions(const Polyhedron& polyhedron, const std::vector<Index>& faces, Grouping as);

/// Gives every rim point a copy of its vertex, the region's faces these copies, and puts quads between the
/// old and the new rim. Inner edges of the region that end at the rim keep their tension and crease. The
/// Euler number stays. O(corners of the regions).
void raise_regions(MeshEditor& draft, const Polyhedron& polyhedron, std::vector<Region>& regions);

}  // namespace hariko
