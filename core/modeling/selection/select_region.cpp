#include "core/modeling/selection/select_region.hpp"

#include <algorithm>

#include "core/modeling/selection/element_flags.hpp"

namespace hariko {
namespace {

std::vector<char>& of_kind(ElementFlags& flags, ElementKind kind) {
  return kind == ElementKind::vertex ? flags.vertices : kind == ElementKind::edge ? flags.edges : flags.faces;
}

void flip(std::vector<char>& flags) {
  for (char& flag : flags) flag = !flag;
}

ElementFlags grown(const HalfEdgeMesh& mesh, const ElementFlags& given) {
  ElementFlags out = given;
  std::vector<char> touched_faces(mesh.face_count(), 0);  // faces with a selected vertex
  std::vector<char> at_edge(mesh.vertex_count(), 0), at_face = at_edge;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index v = mesh.origin(h), w = mesh.target(h);
    if (given.vertices[v]) touched_faces[mesh.face(h)] = 1;
    if (given.edges[mesh.edge(h)]) at_edge[v] = at_edge[w] = 1;
    if (given.faces[mesh.face(h)]) at_face[v] = 1;
  }
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index v = mesh.origin(h), w = mesh.target(h);
    if (touched_faces[mesh.face(h)]) out.vertices[v] = 1;
    if (at_edge[v] || at_edge[w]) out.edges[mesh.edge(h)] = 1;
    if (at_face[v]) out.faces[mesh.face(h)] = 1;
  }
  return out;
}

}  // namespace

ElementSet select_all(const Polyhedron& polyhedron, ElementKind kind) {
  return invert(polyhedron, {}, kind);
}

ElementSet invert(const Polyhedron& polyhedron, const ElementSet& set, ElementKind kind) {
  ElementFlags given(polyhedron, set), out(polyhedron);
  of_kind(out, kind) = of_kind(given, kind);
  flip(of_kind(out, kind));
  return out.to_set(polyhedron);
}

ElementSet grow(const Polyhedron& polyhedron, const ElementSet& set) {
  return grown(polyhedron.topology(), ElementFlags(polyhedron, set)).to_set(polyhedron);
}

ElementSet shrink(const Polyhedron& polyhedron, const ElementSet& set) {
  ElementFlags outside(polyhedron, set);
  flip(outside.vertices);
  flip(outside.edges);
  flip(outside.faces);
  ElementFlags out = grown(polyhedron.topology(), outside);
  flip(out.vertices);
  flip(out.edges);
  flip(out.faces);
  return out.to_set(polyhedron);
}

ElementSet linked(const Polyhedron& polyhedron, const ElementSet& set) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const ElementFlags given(polyhedron, set);
  const std::vector<Index> component = mesh.face_components();
  std::vector<char> touched(mesh.face_count(), 0);  // per component
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    if (given.vertices[mesh.origin(h)] || given.edges[mesh.edge(h)] || given.faces[mesh.face(h)])
      touched[component[mesh.face(h)]] = 1;
  const bool any_vertex = !set.vertices.empty(), any_edge = !set.edges.empty(), any_face = !set.faces.empty();
  ElementFlags out = given;  // isolated vertices are linked to themselves
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    if (!touched[component[mesh.face(h)]]) continue;
    if (any_vertex) out.vertices[mesh.origin(h)] = 1;
    if (any_edge) out.edges[mesh.edge(h)] = 1;
    if (any_face) out.faces[mesh.face(h)] = 1;
  }
  return out.to_set(polyhedron);
}

ElementSet boundary_of_faces(const Polyhedron& polyhedron, const ElementSet& set) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const std::vector<char> chosen = face_flags(polyhedron, set.faces);
  ElementFlags out(polyhedron);
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index twin = mesh.twin(h);
    if (chosen[mesh.face(h)] && (twin == no_index || !chosen[mesh.face(twin)])) out.edges[mesh.edge(h)] = 1;
  }
  return out.to_set(polyhedron);
}

}  // namespace hariko
