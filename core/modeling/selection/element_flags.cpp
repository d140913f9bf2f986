#include "core/modeling/selection/element_flags.hpp"

namespace hariko {

ElementFlags::ElementFlags(const Polyhedron& polyhedron)
    : vertices(polyhedron.vertex_count(), 0),
      edges(polyhedron.edge_count(), 0),
      faces(polyhedron.face_count(), 0) {}

ElementFlags::ElementFlags(const Polyhedron& polyhedron, const ElementSet& set) : ElementFlags(polyhedron) {
  for (const VertexId id : set.vertices)
    if (const Index v = polyhedron.find(id); v != no_index) vertices[v] = 1;
  // Looking up an edge costs O(valence); looking up its id in the set does not.
  if (!set.edges.empty())
    for (Index e = 0; e < polyhedron.edge_count(); ++e) edges[e] = set.edges.contains(polyhedron.edge_id(e));
  faces = face_flags(polyhedron, set.faces);
}

ElementSet ElementFlags::to_set(const Polyhedron& polyhedron) const {
  ElementSet set;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    if (vertices[v]) set.vertices.insert(set.vertices.end(), polyhedron.vertex_id(v));
  for (Index e = 0; e < polyhedron.edge_count(); ++e)
    if (edges[e]) set.edges.insert(polyhedron.edge_id(e));
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    if (faces[f]) set.faces.insert(set.faces.end(), polyhedron.face_id(f));
  return set;
}

std::vector<char> face_flags(const Polyhedron& polyhedron, const std::set<FaceId>& faces) {
  std::vector<char> flags(polyhedron.face_count(), 0);
  for (const FaceId id : faces)
    if (const Index f = polyhedron.find(id); f != no_index) flags[f] = 1;
  return flags;
}

}  // namespace hariko
