#include "core/polyhedron/corner_fans.hpp"
#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/face_check.hpp"
#include "core/polyhedron/repair.hpp"

namespace hariko {

namespace {

/// Gives every fan but the first its own copy of the vertex, at the chosen vertices; copies are appended at
/// the end.
template <class Choose>
PolygonMesh split_fans(const PolygonMesh& mesh, const CornerFans& fans, Choose&& choose) {
  PolygonMesh out = mesh;
  std::vector<Index> first_copy(mesh.positions.size(), no_index);  // copy for fan 1
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (fans.fan_count[v] < 2 || !choose(v)) continue;
    first_copy[v] = static_cast<Index>(out.positions.size());
    out.positions.insert(out.positions.end(), fans.fan_count[v] - 1, mesh.positions[v]);
  }
  const Index added = static_cast<Index>(out.positions.size() - mesh.positions.size());
  for (std::size_t h = 0; h < out.face_vertices.size(); ++h) {
    const Index v = mesh.face_vertices[h], fan = fans.fan[h];
    if (v >= mesh.positions.size())
      out.face_vertices[h] = v < no_index - added ? v + added : no_index;  // out of range before and after
    else if (fan != no_index && fan > 0 && first_copy[v] != no_index)
      out.face_vertices[h] = first_copy[v] + fan - 1;
  }
  return out;
}

CornerFans fans_of(const PolygonMesh& mesh) {
  const std::vector<char> sound = sound_faces(mesh);
  return find_corner_fans(mesh, sound, EdgeTable(mesh, sound));
}

}  // namespace

// Fans are cut at faulty edges, and each fan starts and ends at most once, so every directed edge of the
// result belongs to at most one face.
PolygonMesh split_nonmanifold_edges(const PolygonMesh& mesh) {
  const CornerFans fans = fans_of(mesh);
  return split_fans(mesh, fans, [&](std::size_t v) { return fans.at_faulty_edge[v] != 0; });
}

PolygonMesh split_nonmanifold_vertices(const PolygonMesh& mesh) {
  const CornerFans fans = fans_of(mesh);
  return split_fans(mesh, fans, [&](std::size_t v) { return fans.at_faulty_edge[v] == 0; });
}

}  // namespace hariko
