#include "core/modeling/surfacing/automatic_tension.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/document/edits/edits.hpp"

namespace hariko {

Shaping with_automatic_tension(const Polyhedron& polyhedron, const Shaping& shaping, double exponent) {
  if (exponent == 0 || polyhedron.edge_count() == 0) return shaping;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<double> lengths(mesh.edge_count());
  double sum = 0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    lengths[e] = (polyhedron.position(mesh.target(h)) - polyhedron.position(mesh.origin(h))).norm();
    sum += lengths[e];
  }
  const double mean = sum / mesh.edge_count();
  std::vector<std::pair<EdgeId, double>> tensions;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const EdgeId id = polyhedron.edge_id(e);
    const double factor = lengths[e] > 0 ? std::pow(mean / lengths[e], exponent) : max_beta;
    tensions.emplace_back(id, std::clamp(shaping.beta.get_or(id, 1) * factor, min_beta, max_beta));
  }
  std::sort(tensions.begin(), tensions.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Shaping out = shaping;
  out.beta = {};
  for (const auto& [id, value] : tensions)
    if (value != 1) out.beta.set(id, value);
  return out;
}

}  // namespace hariko
