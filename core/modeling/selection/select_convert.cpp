#include "core/modeling/selection/select_convert.hpp"

#include <algorithm>

#include "core/modeling/selection/element_flags.hpp"

namespace hariko {
namespace {

/// Whether test(h) holds for all half-edges of face f (`inside`), or for any one (`touching`).
template <class Test>
bool passes(const HalfEdgeMesh& mesh, Index f, Reach reach, Test&& test) {
  for (Index h = mesh.face_begin(f); h < mesh.face_end(f); ++h)
    if (test(h) != (reach == Reach::inside)) return reach == Reach::touching;
  return reach == Reach::inside;
}

}  // namespace

ElementSet to_vertices(const Polyhedron& polyhedron, const ElementSet& set) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const ElementFlags given(polyhedron, set);
  ElementFlags out(polyhedron);
  out.vertices = given.vertices;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    if (given.faces[mesh.face(h)]) out.vertices[mesh.origin(h)] = 1;
    if (given.edges[mesh.edge(h)]) out.vertices[mesh.origin(h)] = out.vertices[mesh.target(h)] = 1;
  }
  return out.to_set(polyhedron);
}

ElementSet to_edges(const Polyhedron& polyhedron, const ElementSet& set, Reach reach) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const ElementFlags given(polyhedron, set);
  ElementFlags out(polyhedron);
  out.edges = given.edges;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const int ends = (given.vertices[mesh.origin(h)] != 0) + (given.vertices[mesh.target(h)] != 0);
    if (given.faces[mesh.face(h)] || ends == 2 || (reach == Reach::touching && ends > 0))
      out.edges[mesh.edge(h)] = 1;
  }
  return out.to_set(polyhedron);
}

ElementSet to_faces(const Polyhedron& polyhedron, const ElementSet& set, Reach reach) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const ElementFlags given(polyhedron, set);
  ElementFlags out(polyhedron);
  out.faces = given.faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (passes(mesh, f, reach, [&](Index h) { return given.vertices[mesh.origin(h)] != 0; }) ||
        passes(mesh, f, reach, [&](Index h) { return given.edges[mesh.edge(h)] != 0; }))
      out.faces[f] = 1;
  }
  return out.to_set(polyhedron);
}

}  // namespace hariko
