#include "core/skinning/skin_caps.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace hariko {

namespace {

void add_cap(const Skin& skin, const SkinPlan& plan, SkinMesh& out, bool first) {
  PolygonMesh& mesh = out.control.mesh;
  std::vector<Index> ring = first ? out.section_rows.front() : out.section_rows.back();
  if (ring.size() < 3) return;
  // Against the direction in which the strip's faces use the edges of the row.
  if (!first) std::reverse(ring.begin(), ring.end());
  const std::size_t n = ring.size();
  if (skin.caps == Caps::flat) {
    for (std::size_t i = 0; i < n; ++i)
      out.control.creases.push_back(
          {std::min(ring[i], ring[(i + 1) % n]), std::max(ring[i], ring[(i + 1) % n]), infinitely_sharp});
    mesh.add_face(ring);
    return;
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
}

}  // namespace

void add_caps(const Skin& skin, const SkinPlan& plan, SkinMesh& mesh) {
  if (skin.caps == Caps::none || skin.path.closed || !plan.closed_sections) return;
  add_cap(skin, plan, mesh, true);
  add_cap(skin, plan, mesh, false);
}

}  // namespace hariko
