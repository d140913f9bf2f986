#include "core/exchange/repair/single_normals.hpp"

namespace hariko {

VertexTriangles with_single_normals(const TriangleMesh& mesh) {
  VertexTriangles out;
  if (mesh.normal_triangles.empty()) {
    out.positions = mesh.positions;
    out.triangles = mesh.triangles;
    return out;
  }
  out.positions.reserve(mesh.positions.size());
  out.normals.reserve(mesh.positions.size());
  out.triangles.reserve(mesh.triangles.size());
  std::vector<Index> first(mesh.positions.size(), no_index);  // first vertex made from each position
  std::vector<Index> next, normal_of;                         // by vertex made
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Index, 3>& triangle = out.triangles.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index position = mesh.triangles[t][corner], normal = mesh.normal_triangles[t][corner];
      Index vertex = first[position];
      while (vertex != no_index && normal_of[vertex] != normal) vertex = next[vertex];
      if (vertex == no_index) {
        vertex = static_cast<Index>(normal_of.size());
        next.push_back(first[position]);
        normal_of.push_back(normal);
        first[position] = vertex;
        out.positions.push_back(mesh.positions[position]);
        out.normals.push_back(mesh.normals[normal]);
      }
      triangle[corner] = vertex;
    }
  }
  return out;
}

}  // namespace hariko
