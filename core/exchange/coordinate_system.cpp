#include "core/exchange/coordinate_system.hpp"

namespace hariko {

TriangleMesh in_space(const FileSpace& space, TriangleMesh mesh, const Vector3& zero) {
  mesh.origin = space.placed(mesh.origin) - zero;
  for (Vector3& position : mesh.positions) position = space.placed(position);
  for (Vector3& normal : mesh.normals) normal = space.turned(normal);
  return mesh;
}

PolygonMesh in_space(const FileSpace& space, PolygonMesh mesh, const Vector3& zero) {
  for (Vector3& position : mesh.positions) position = space.placed(position) - zero;
  return mesh;
}

}  // namespace hariko
