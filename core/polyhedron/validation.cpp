#include "core/polyhedron/validation.hpp"

#include <iterator>

#include "core/polyhedron/mesh_errors.hpp"
#include "core/polyhedron/mesh_warnings.hpp"

namespace hariko {

std::vector<Message> validate(const PolygonMesh& mesh, std::size_t limit) {
  std::vector<Message> out = position_errors(mesh, limit);
  std::vector<Message> errors = connectivity_errors(mesh, limit);
  std::move(errors.begin(), errors.end(), std::back_inserter(out));
  if (!out.empty() || limit == 0) return out;
  const Result<HalfEdgeMesh> topology = HalfEdgeMesh::build(mesh);
  return mesh_warnings(topology.value(), mesh.positions, ElementNames{}, limit);
}

namespace {

/// Calls warn with the mesh's topology, positions and element names.
template <class Warn>
std::vector<Message> with_names(const Polyhedron& polyhedron, std::size_t limit, Warn&& warn) {
  std::vector<VertexId> vertex_ids(polyhedron.vertex_count());
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) vertex_ids[v] = polyhedron.vertex_id(v);
  std::vector<FaceId> face_ids(polyhedron.face_count());
  for (Index f = 0; f < polyhedron.face_count(); ++f) face_ids[f] = polyhedron.face_id(f);
  return warn(polyhedron.topology(), polyhedron.positions(), ElementNames{vertex_ids, face_ids}, limit);
}

}  // namespace

std::vector<Message> warnings_of(const Polyhedron& polyhedron, std::size_t limit) {
  return with_names(polyhedron, limit, mesh_warnings);
}

std::vector<Message> face_shape_warnings_of(const Polyhedron& polyhedron, std::size_t limit) {
  return with_names(polyhedron, limit, face_shape_warnings);
}

}  // namespace hariko
