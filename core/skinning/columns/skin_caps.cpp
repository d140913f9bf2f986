#include "core/skinning/columns/skin_caps.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace hariko {

namespace {

/// Ring of vertices at an end, and the ring that the dome adds.
struct Dome {
  std::vector<Index> ring, inset;
};

Dome add_cap(const Skin& skin, const SkinPlan& plan, SkinMesh& out, bool first) {
  PolygonMesh& mesh = out.control.mesh;
  std::vector<Index> ring = first ? out.section_rows.front() : out.section_rows.back();
  if (ring.size() < 3) return {};
  // Opposite to the direction in which the strip's faces use the edges of the row.
  if (!first) std::reverse(ring.begin(), ring.end());
  const std::size_t n = ring.size();
  if (skin.caps == Caps::flat) {
    for (std::size_t i = 0; i < n; ++i)
      out.control.creases.push_back(
          {std::min(ring[i], ring[(i + 1) % n]), std::max(ring[i], ring[(i + 1) % n]), infinitely_sharp});
    mesh.add_face(ring);
    return {};
  }
  Vector3 centre = Vector3::Zero();
  for (const Index v : ring) centre += mesh.positions[v] / double(n);
  double radius = 0;
  for (const Index v : ring) radius += (mesh.positions[v] - centre).norm() / double(n);
  const Vector3 out_of_tube = (first ? -1.0 : 1.0) * plan.frames.tangent(first ? 0 : 1).normalized();
  std::vector<Index> inset;
  for (const Index v : ring) {
    inset.push_back(Index(mesh.positions.size()));
    mesh.positions.push_back(centre + 0.5 * (mesh.positions[v] - centre) + 0.35 * radius * out_of_tube);
    out.vertices.push_back({});
  }
  for (std::size_t i = 0; i < n; ++i)
    mesh.add_face({ring[i], ring[(i + 1) % n], inset[(i + 1) % n], inset[i]});
  mesh.add_face(inset);
  return {std::move(ring), std::move(inset)};
}

/// Moves the rows under domes so that the end curves stay: a row inside the surface has the curve of (V- + 4
/// V + V+) / 6, with its neighbours across; the end of the tube had that of V. Vertices with other neighbours
/// than in a regular grid stay.
void keep_end_curves(PolygonMesh& mesh, const std::array<Dome, 2>& domes) {
  std::map<Index, Index> above;  // ring vertex -> vertex of the dome
  for (const Dome& dome : domes)
    for (std::size_t i = 0; i < dome.ring.size(); ++i) above[dome.ring[i]] = dome.inset[i];
  struct Around {
    std::set<Index> inside;
    int faces = 0;
    bool quads = true;
  };
  std::map<Index, Around> around;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (!above.contains(face[i])) continue;
      Around& own = around[face[i]];
      ++own.faces;
      own.quads = own.quads && face.size() == 4;
      for (const Index next : {face[(i + 1) % face.size()], face[(i + face.size() - 1) % face.size()]})
        if (!above.contains(next) && next != above[face[i]]) own.inside.insert(next);
    }
  }
  for (const auto& [v, own] : around) {
    if (own.faces != 4 || !own.quads || own.inside.size() != 1) continue;
    mesh.positions[v] =
        (6 * mesh.positions[v] - mesh.positions[*own.inside.begin()] - mesh.positions[above[v]]) / 4;
  }
}

}  // namespace

void add_caps(const Skin& skin, const SkinPlan& plan, SkinMesh& mesh) {
  if (skin.caps == Caps::none || skin.path.closed || !plan.closed_sections) return;
  const std::array<Dome, 2> domes{add_cap(skin, plan, mesh, true), add_cap(skin, plan, mesh, false)};
  keep_end_curves(mesh.control.mesh, domes);
}

}  // namespace hariko
