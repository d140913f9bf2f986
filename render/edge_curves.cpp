#include "render/edge_curves.hpp"

#include <algorithm>
#include <utility>

namespace hariko {

std::shared_ptr<const EdgeCurves> edge_curves(const DisplayMesh& mesh, const DisplayPolyhedron& polyhedron) {
  auto out = std::make_shared<EdgeCurves>();
  out->curves = mesh.curves();
  std::vector<std::pair<EdgeId, Index>> edges;
  edges.reserve(polyhedron.edges.size());
  for (Index e = 0; e < polyhedron.edges.size(); ++e) edges.emplace_back(polyhedron.edge_id(e), e);
  std::sort(edges.begin(), edges.end());
  std::vector<std::pair<Index, EdgeCurves::Run>> found;
  for (const DisplayCurve& curve : mesh.curves()->curves) {
    if (curve.source.kind != Element::Kind::edge || curve.segment_count == 0) continue;
    const EdgeId id = EdgeId::from_packed(curve.source.id);
    const auto at = std::lower_bound(edges.begin(), edges.end(), std::pair(id, Index(0)));
    if (at == edges.end() || at->first != id) continue;
    found.push_back({at->second, {curve.kind, curve.first_segment, curve.segment_count}});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  out->offsets.assign(polyhedron.edges.size() + 1, 0);
  for (const auto& [edge, run] : found) {
    ++out->offsets[edge + 1];
    out->runs.push_back(run);
  }
  for (std::size_t e = 0; e < polyhedron.edges.size(); ++e) out->offsets[e + 1] += out->offsets[e];
  return out;
}

}  // namespace hariko
