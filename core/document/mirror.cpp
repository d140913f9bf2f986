#include "core/document/mirror.hpp"

#include <cmath>

namespace hariko {

Result<Done> check_mirror(const Mirror& mirror) {
  if (std::isfinite(mirror.weld_distance) && mirror.weld_distance >= 0) return Done{};
  return make_error(e_mirror_invalid, "The weld distance of the mirror is not a length.",
                    "Give a length of 0 or more.");
}

std::vector<char> mirror_seam(const Polyhedron& polyhedron, const Vector3& origin, const Mirror& mirror) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  const Eigen::Index axis = index_of(mirror.axis);
  const auto is_near = [&](Index v) {
    return std::abs(origin[axis] + polyhedron.position(v)[axis]) <= mirror.weld_distance;
  };
  std::vector<char> seam(mesh.vertex_count(), 0);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (!mesh.is_border_edge(e)) continue;
    const Index a = mesh.origin(mesh.half_edge_of_edge(e)), b = mesh.target(mesh.half_edge_of_edge(e));
    if (is_near(a) && is_near(b)) seam[a] = seam[b] = 1;
  }
  return seam;
}

}  // namespace hariko
