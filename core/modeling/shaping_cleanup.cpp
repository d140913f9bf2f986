#include "core/modeling/shaping_cleanup.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>
#include <vector>

namespace hariko::detail {
namespace {

/// Edge of a fan, as pinned tangents refer to it.
struct FanEdge {
  VertexId other;
  bool sharp;
  friend bool operator==(const FanEdge&, const FanEdge&) = default;
};

/// Edges at v in the order of its basis (see HalfEdgeMesh); empty where v has no faces.
std::vector<FanEdge> fan_at(const Polyhedron& polyhedron, const Shaping& shaping, Index v) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<FanEdge> fan;
  for (const auto& [end, other] : fan_ends(mesh, v)) {
    const Index h = end / 2;
    const bool sharp = mesh.twin(h) == no_index || shaping.crease.contains(polyhedron.edge_id(mesh.edge(h)));
    fan.push_back({polyhedron.vertex_id(other), sharp});
  }
  return fan;
}

bool corner_tag_fits(const Polyhedron& polyhedron, const Shaping& shaping, Index v) {
  if (polyhedron.topology().is_border_vertex(v)) return true;
  const auto fan = fan_at(polyhedron, shaping, v);
  return std::count_if(fan.begin(), fan.end(), [](const FanEdge& edge) { return edge.sharp; }) >= 2;
}

/// Whether both polyhedra have the face, with the same vertices in any order.
bool same_corners(const Polyhedron& a, const Polyhedron& b, FaceId id) {
  const auto corners = [id](const Polyhedron& polyhedron) {
    std::vector<VertexId> out;
    if (const Index f = polyhedron.find(id); f != no_index)
      for (const Index v : polyhedron.topology().face_vertices(f)) out.push_back(polyhedron.vertex_id(v));
    std::sort(out.begin(), out.end());
    return out;
  };
  const std::vector<VertexId> first = corners(a);
  return !first.empty() && first == corners(b);
}

template <class Id, class Value, class Keep>
FlatMap<Id, Value> kept_entries(const FlatMap<Id, Value>& map, Keep&& keep) {
  FlatMap<Id, Value> out;
  for (const auto& [id, value] : map)
    if (keep(id)) out.set(id, value);
  return out;
}

}  // namespace

Shaping shaping_on(const Polyhedron& after, const Shaping& shaping, const Polyhedron& before,
                   const Shaping& shaping_before) {
  const auto has_vertex = [&](VertexId id) {
    const Index v = after.find(id);
    return v != no_index && after.topology().outgoing(v) != no_index;
  };
  const auto has_edge = [&](EdgeId id) { return after.find(id) != no_index; };

  Shaping out;
  out.alpha = kept_entries(shaping.alpha, has_vertex);
  out.beta = kept_entries(shaping.beta, has_edge);
  out.crease = kept_entries(shaping.crease, has_edge);
  for (const auto& [id, tag] : shaping.tag)
    if (has_vertex(id) && (tag != VertexTag::corner || corner_tag_fits(after, out, after.find(id))))
      out.tag.set(id, tag);
  for (const auto& [id, pin] : shaping.pin) {
    if (!has_vertex(id)) continue;
    const Index old = before.find(id);
    const bool same = pin.kind == Pin::Kind::normal ||
                      (old != no_index &&
                       shaping.tag.get_or(id, VertexTag::automatic) ==
                           shaping_before.tag.get_or(id, VertexTag::automatic) &&
                       fan_at(before, shaping_before, old) == fan_at(after, out, after.find(id)));
    if (same) {
      out.pin.set(id, pin);
    } else if (pin.vectors.size() == 2) {
      const Vector3 normal = pin.vectors[1].stableNormalized().cross(pin.vectors[0].stableNormalized());
      if (normal.allFinite() && normal.norm() > 1e-9) out.pin.set(id, {Pin::Kind::normal, {normal}});
    }
  }
  for (const auto& [id, form] : shaping.form) {
    const Index old = before.find(id);
    if (old != no_index && has_vertex(id) &&
        fan_at(before, shaping_before, old) == fan_at(after, out, after.find(id))) {
      // Some of its edges may have crossed faces that were cut in the preparation of the surface.
      KeptForm known = form;
      std::erase_if(known.edges, [&](const KeptForm::Edge& edge) { return !has_vertex(edge.to); });
      out.form.set(id, std::move(known));
    }
  }
  for (const auto& [id, area] : shaping.kept_area)
    if (same_corners(before, after, id)) out.kept_area.set(id, area);
  return out;
}

}  // namespace hariko::detail
