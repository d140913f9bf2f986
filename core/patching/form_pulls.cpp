#include "core/patching/form_pulls.hpp"

#include <algorithm>
#include <cmath>

#include "core/network/kept_form.hpp"

namespace hariko {
namespace {

/// Power of a length: the energy of mode FAIR makes forces of it.
constexpr double force_power = 1.5;

/// Half-edges by which ends lead to the left: an end at the target of its half-edge looks from the other
/// side.
double left_sign(const HalfEdgeMesh& mesh, Index end) {
  const Index h = end / 2, first = mesh.half_edge_of_edge(mesh.edge(h));
  const bool at_origin_of_first = (h == first) == (end % 2 == 0);
  return at_origin_of_first ? 1 : -1;
}

}  // namespace

std::vector<RimBend> form_pulls(const Polyhedron& polyhedron, const Shaping& shaping,
                                const VertexFrames& frames) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<RimBend> of_edge(shaping.form.empty() ? 0 : mesh.edge_count());
  for (const auto& [id, form] : shaping.form) {
    const Index v = polyhedron.find(id);
    if (v == no_index || mesh.outgoing(v) == no_index) continue;
    const std::vector<FanEnd> fan = fan_ends(mesh, v);
    const std::vector<Matrix3> directions = edge_directions(polyhedron, v, fan);
    for (std::size_t k = 0; k < fan.size(); ++k) {
      const KeptForm::Edge* edge = form.find(polyhedron.vertex_id(fan[k].other));
      const Index e = mesh.edge(fan[k].end / 2), first = mesh.half_edge_of_edge(e);
      if (!edge || frames.sharp[e] || edge->pull.isZero(0)) continue;
      const Vector3 force = left_sign(mesh, fan[k].end) *
                            std::pow(frames.charts.edge_length[e], force_power) *
                            (directions[k] * edge->pull);
      of_edge[e].half_edge = first;
      (mesh.origin(first) == v ? of_edge[e].at_origin : of_edge[e].at_target) = force;
    }
  }
  std::erase_if(of_edge, [](const RimBend& each) { return each.half_edge == no_index; });
  return of_edge;
}

}  // namespace hariko
