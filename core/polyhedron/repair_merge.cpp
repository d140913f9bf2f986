#include <algorithm>

#include "core/base/index_list.hpp"
#include "core/polyhedron/near_vertices.hpp"
#include "core/polyhedron/repair.hpp"

namespace hariko {

namespace {

/// Mesh with the kept vertices only, in their order. Corners are mapped by target[]; indices out of range
/// stay out of range.
PolygonMesh with_kept_vertices(const PolygonMesh& mesh, const std::vector<char>& keep,
                               const std::vector<Index>& target) {
  PolygonMesh out;
  out.face_offsets = mesh.face_offsets;
  std::vector<Index> moved(mesh.positions.size(), no_index);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!keep[v]) continue;
    moved[v] = static_cast<Index>(out.positions.size());
    out.positions.push_back(mesh.positions[v]);
  }
  out.face_vertices.reserve(mesh.face_vertices.size());
  for (Index v : mesh.face_vertices) out.face_vertices.push_back(v < moved.size() ? moved[target[v]] : v);
  return out;
}

}  // namespace

PolygonMesh remove_isolated_vertices(const PolygonMesh& mesh) {
  std::vector<char> used(mesh.positions.size(), 0);
  for (Index v : mesh.face_vertices)
    if (v < used.size()) used[v] = 1;
  return with_kept_vertices(mesh, used, ascending_indices(mesh.positions.size()));
}

PolygonMesh weld(const PolygonMesh& mesh, double distance) {
  const std::vector<Index> target = representatives(mesh.positions, distance);
  std::vector<char> keep(target.size());
  for (Index v = 0; v < target.size(); ++v) keep[v] = target[v] == v;
  const PolygonMesh merged = with_kept_vertices(mesh, keep, target);

  PolygonMesh out;
  out.positions = merged.positions;
  std::vector<Index> corners;
  for (std::size_t f = 0; f < merged.face_count(); ++f) {
    const std::span<const Index> face = merged.face(f);
    corners.assign(face.begin(), face.end());
    remove_repeats(corners);
    if (corners.size() >= 3) out.add_face(corners);
  }
  return out;
}

}  // namespace hariko
