#include "core/subdivision/control_mesh.hpp"

#include <algorithm>
#include <unordered_set>

#include "core/geometry/edge_key.hpp"

namespace hariko {

bool ControlMesh::all_quads() const {
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    if (mesh.face(f).size() != 4) return false;
  return true;
}

Result<Done> check(const ControlMesh& control) {
  const PolygonMesh& mesh = control.mesh;
  const auto wrong = [](std::string text, Element element) {
    return make_error(e_control_mesh, std::move(text), "Change the sections or their correspondences there.",
                      element);
  };
  if (mesh.face_count() == 0) return wrong("The control mesh has no faces.", {});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (!mesh.positions[v].allFinite())
      return wrong("A control point is not a finite number.", {Element::Kind::vertex, v});
  std::unordered_set<std::uint64_t> seen;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Element element{Element::Kind::face, f};
    if (face.size() < 3) return wrong("A face of the control mesh has fewer than three corners.", element);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i], b = face[(i + 1) % face.size()];
      if (a >= mesh.positions.size())
        return wrong("A face uses a control point that does not exist.", element);
      if (a == b || !seen.insert(half_edge_key(a, b)).second)
        return wrong("The control mesh folds onto itself: an edge is used twice in one direction.", element);
    }
  }
  return Done{};
}

bool same_topology(const ControlMesh& a, const ControlMesh& b) {
  return a.mesh.positions.size() == b.mesh.positions.size() && a.mesh.face_offsets == b.mesh.face_offsets &&
         a.mesh.face_vertices == b.mesh.face_vertices && a.creases == b.creases && a.corners == b.corners;
}

}  // namespace hariko
