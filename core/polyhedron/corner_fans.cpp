#include "core/polyhedron/corner_fans.hpp"

namespace hariko {

namespace {

/// Previous corner in its face, per corner of a sound face.
std::vector<Index> previous_corners(const PolygonMesh& mesh) {
  std::vector<Index> previous(mesh.face_vertices.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const Index begin = mesh.face_offsets[f], end = mesh.face_offsets[f + 1];
    for (Index h = begin; h < end; ++h) previous[h] = h == begin ? end - 1 : h - 1;
  }
  return previous;
}

}  // namespace

std::vector<Index> find_twins(const PolygonMesh& mesh, const EdgeTable& edges) {
  std::vector<Index> twin(mesh.face_vertices.size(), no_index);
  edges.for_each_edge([&](Index, Index, std::span<const EdgeUse> uses) {
    if (uses.size() != 2 || !is_manifold_edge(mesh, uses)) return;
    twin[uses[0].corner] = uses[1].corner;
    twin[uses[1].corner] = uses[0].corner;
  });
  return twin;
}

CornerFans find_corner_fans(const PolygonMesh& mesh, const std::vector<char>& sound, const EdgeTable& edges) {
  return find_corner_fans(mesh, sound, edges, find_twins(mesh, edges));
}

CornerFans find_corner_fans(const PolygonMesh& mesh, const std::vector<char>& sound, const EdgeTable& edges,
                            const std::vector<Index>& twin) {
  const std::size_t vertex_count = mesh.positions.size(), corner_count = mesh.face_vertices.size();
  CornerFans out;
  out.fan.assign(corner_count, no_index);
  out.fan_count.assign(vertex_count, 0);
  out.at_faulty_edge.assign(vertex_count, 0);
  out.at_unsound_face.assign(vertex_count, 0);

  edges.for_each_edge([&](Index low, Index high, std::span<const EdgeUse> uses) {
    if (!is_manifold_edge(mesh, uses)) out.at_faulty_edge[low] = out.at_faulty_edge[high] = 1;
  });

  // The next corner counter-clockwise is a partial injection: its paths are the open fans, its cycles the
  // closed fans.
  const std::vector<Index> previous = previous_corners(mesh);
  const auto label_from = [&](Index start) {
    const Index number = out.fan_count[mesh.face_vertices[start]]++;
    for (Index h = start; h != no_index && out.fan[h] == no_index; h = twin[previous[h]]) out.fan[h] = number;
  };
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      for (Index h = mesh.face_offsets[f]; h < mesh.face_offsets[f + 1]; ++h) {
        if (!sound[f]) {
          if (mesh.face_vertices[h] < vertex_count) out.at_unsound_face[mesh.face_vertices[h]] = 1;
        } else if (out.fan[h] == no_index && (pass == 1 || twin[h] == no_index)) {
          label_from(h);
        }
      }
    }
  }
  return out;
}

}  // namespace hariko
