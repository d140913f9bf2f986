#include "core/modeling/operations/short_edges.hpp"

#include <algorithm>
#include <vector>

#include "core/document/edits/edge_set.hpp"
#include "core/document/edits/edit_elements.hpp"

namespace hariko {

void tighten_short_edges(PolyhedronSource& after, const PolyhedronSource& before) {
  constexpr double long_ratio = 2;
  const Polyhedron& polyhedron = after.polyhedron;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<double> length(mesh.edge_count()), longest(mesh.vertex_count(), 0);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e), a = mesh.origin(h), b = mesh.target(h);
    length[e] = (polyhedron.position(b) - polyhedron.position(a)).stableNorm();
    longest[a] = std::max(longest[a], length[e]);
    longest[b] = std::max(longest[b], length[e]);
  }
  const detail::EdgeSet old(before.polyhedron);
  std::vector<std::pair<EdgeId, double>> tight;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const EdgeId id = polyhedron.edge_id(e);
    if (!(length[e] > 0) || old.contains(id) || after.shaping->beta.contains(id)) continue;
    const Index h = mesh.half_edge_of_edge(e);
    const double ratio = std::max(longest[mesh.origin(h)], longest[mesh.target(h)]) / length[e];
    if (ratio > long_ratio) tight.emplace_back(id, std::min(ratio * ratio, max_beta));
  }
  if (tight.empty()) return;
  std::sort(tight.begin(), tight.end());
  Shaping shaping = *after.shaping;
  for (const auto& [id, beta] : tight) shaping.beta.set(id, beta);
  after.shaping = std::move(shaping);
}

}  // namespace hariko
