#include "core/modeling/operations/fill_hole.hpp"

#include <utility>
#include <vector>

#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/operations/border_loops.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {

Result<EditResult> fill_holes(const PolyhedronSource& source, std::span<const EdgeId> edges) {
  const Polyhedron& polyhedron = source.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto chosen = selected(polyhedron, edges, "Select an edge of the hole.");
  if (!chosen) return chosen.error();
  MeshEditor draft(source);
  ElementSet selection;
  std::vector<char> filled(mesh.vertex_count(), 0);  // a vertex lies on one border at most
  for (const Index e : *chosen) {
    if (!mesh.is_border_edge(e))
      return make_error(e_wrong_selection, "The edge is not at a hole: it has faces on both sides.",
                        "Select edges of the border.", element_of(polyhedron.edge_id(e)));
    const std::vector<Index> loop = border_loop(mesh, e);
    if (filled[loop[0]]) continue;
    std::vector<VertexId> corners;
    for (const Index v : loop) {
      filled[v] = 1;
      corners.push_back(polyhedron.vertex_id(v));
    }
    selection.faces.insert(draft.add_face(std::move(corners)));
  }
  return std::move(draft).finish(std::move(selection));
}

}  // namespace hariko
