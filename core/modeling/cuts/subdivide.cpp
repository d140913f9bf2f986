#include "core/modeling/cuts/subdivide.hpp"

#include <map>
#include <utility>
#include <vector>

#include "core/modeling/cuts/edge_points.hpp"
#include "core/modeling/cuts/loop_cut.hpp"
#include "core/modeling/mesh_editor.hpp"
#include "core/modeling/operations/face_geometry.hpp"
#include "core/modeling/selection/selected.hpp"

namespace hariko {

Result<EditResult> subdivide_edges(const PolyhedronSource& source, std::span<const EdgeId> edges, int count,
                                   const SurfaceForm* on) {
  if (count < 1 || count > max_cuts)
    return make_error(e_bad_amount, "The number of points is out of range.", "Use 1 to 1000 points.");
  const Polyhedron& polyhedron = source.polyhedron;
  const auto chosen = selected(polyhedron, edges, "Select the edges to subdivide.");
  if (!chosen) return chosen.error();
  if (chosen->size() * static_cast<std::size_t>(count) > max_new_elements)
    return make_error(e_too_many_elements, "So many points would make more vertices than can be handled.",
                      "Use fewer points.");
  const std::vector<double> shares = even_shares(count);
  MeshEditor draft(source);
  ElementSet selection;
  for (const Index e : *chosen) {
    const EdgeId edge = polyhedron.edge_id(e);
    const auto points = add_edge_points(draft, edge.low, edge.high, shares);
    selection.vertices.insert(points.begin(), points.end());
  }
  return finish_refined(std::move(draft), std::move(selection), on);
}

Result<EditResult> subdivide_faces(const PolyhedronSource& source, std::span<const FaceId> faces,
                                   const SurfaceForm* on) {
  const Polyhedron& polyhedron = source.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto chosen = selected(polyhedron, faces, "Select the faces to subdivide.");
  if (!chosen) return chosen.error();
  const double half = 0.5;
  MeshEditor draft(source);
  std::map<Index, VertexId> middle;  // per edge
  for (const Index f : *chosen)
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      const Index e = mesh.edge(h);
      if (middle.contains(e)) continue;
      const EdgeId edge = polyhedron.edge_id(e);
      middle[e] = add_edge_points(draft, edge.low, edge.high, std::span<const double>(&half, 1))[0];
    }
  ElementSet selection;
  for (const Index f : *chosen) {
    const auto middle_of_face = star_centre(polyhedron, f);
    if (!middle_of_face) return middle_of_face.error();
    const VertexId centre =
        draft.add_vertex(*middle_of_face, FacePoint{polyhedron.face_id(f), *middle_of_face});
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      std::vector<VertexId> quad{polyhedron.vertex_id(mesh.origin(h)), middle[mesh.edge(h)], centre,
                                 middle[mesh.edge(mesh.previous(h))]};
      FaceId id = polyhedron.face_id(f);
      if (h == mesh.face_begin(f))
        draft.set_face(id, std::move(quad));
      else
        id = draft.add_face(std::move(quad));
      selection.faces.insert(id);
    }
  }
  return finish_refined(std::move(draft), std::move(selection), on);
}

Result<EditResult> poke_faces(const PolyhedronSource& source, std::span<const FaceId> faces,
                              const SurfaceForm* on) {
  const Polyhedron& polyhedron = source.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const auto chosen = selected(polyhedron, faces, "Select the faces to poke.");
  if (!chosen) return chosen.error();
  MeshEditor draft(source);
  ElementSet selection;
  for (const Index f : *chosen) {
    const auto middle_of_face = star_centre(polyhedron, f);
    if (!middle_of_face) return middle_of_face.error();
    const VertexId centre =
        draft.add_vertex(*middle_of_face, FacePoint{polyhedron.face_id(f), *middle_of_face});
    for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h) {
      std::vector<VertexId> triangle{polyhedron.vertex_id(mesh.origin(h)),
                                     polyhedron.vertex_id(mesh.target(h)), centre};
      if (h == mesh.face_begin(f))
        draft.set_face(polyhedron.face_id(f), std::move(triangle));
      else
        draft.add_face(std::move(triangle));
    }
    selection.vertices.insert(centre);
  }
  return finish_refined(std::move(draft), std::move(selection), on);
}

}  // namespace hariko
