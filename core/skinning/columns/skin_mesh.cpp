#include "core/skinning/columns/skin_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

namespace hariko {

void flip_faces(PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    std::reverse(mesh.face_vertices.begin() + mesh.face_offsets[f] + 1,
                 mesh.face_vertices.begin() + mesh.face_offsets[f + 1]);
}

double tube_volume(const PolygonMesh& mesh) {
  Vector3 centre = Vector3::Zero();
  for (const Vector3& p : mesh.positions) centre += p / double(mesh.positions.size());
  double volume = 0;
  std::map<Index, Index> border;  // a -> b for reversed edges without a face on the other side
  std::map<std::pair<Index, Index>, int> used;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Vector3 a = mesh.positions[face[0]] - centre;
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      volume += a.dot((mesh.positions[face[i]] - centre).cross(mesh.positions[face[i + 1]] - centre));
    for (std::size_t i = 0; i < face.size(); ++i) used[{face[i], face[(i + 1) % face.size()]}] = 1;
  }
  for (const auto& [edge, one] : used)
    if (!used.contains({edge.second, edge.first})) border[edge.second] = edge.first;
  while (!border.empty()) {
    std::vector<Index> loop;
    Index at = border.begin()->first;
    for (auto found = border.find(at); found != border.end(); found = border.find(at)) {
      loop.push_back(at);
      at = found->second;
      border.erase(found);
    }
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      volume += (mesh.positions[loop[0]] - centre)
                    .dot((mesh.positions[loop[i]] - centre).cross(mesh.positions[loop[i + 1]] - centre));
  }
  return volume;
}

}  // namespace hariko
