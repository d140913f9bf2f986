#include "core/modeling/operations/delete_elements.hpp"

#include <set>
#include <utility>

#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {
namespace {

Result<EditResult> without_faces(const PolyhedronSource& source, const std::set<Index>& faces) {
  MeshEditor draft(source);
  for (const Index f : faces) draft.remove_face(source.polyhedron.face_id(f));
  return std::move(draft).finish({});
}

}  // namespace

Result<EditResult> delete_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices) {
  const auto chosen = selected(source.polyhedron, vertices, "Select vertices.");
  if (!chosen) return chosen.error();
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  std::set<Index> faces;
  for (const Index v : *chosen)
    for (const Index h : mesh.fan_corners(v)) faces.insert(mesh.face(h));
  return without_faces(source, faces);
}

Result<EditResult> delete_edges(const PolyhedronSource& source, std::span<const EdgeId> edges) {
  const auto chosen = selected(source.polyhedron, edges, "Select edges.");
  if (!chosen) return chosen.error();
  const HalfEdgeMesh& mesh = source.polyhedron.topology();
  std::set<Index> faces;
  for (const Index e : *chosen) {
    const Index h = mesh.half_edge_of_edge(e);
    faces.insert(mesh.face(h));
    if (mesh.twin(h) != no_index) faces.insert(mesh.face(mesh.twin(h)));
  }
  return without_faces(source, faces);
}

Result<EditResult> delete_faces(const PolyhedronSource& source, std::span<const FaceId> faces) {
  const auto chosen = selected(source.polyhedron, faces, "Select faces.");
  if (!chosen) return chosen.error();
  return without_faces(source, {chosen->begin(), chosen->end()});
}

}  // namespace hariko
