#include "render/display_polyhedron.hpp"

namespace hariko {

namespace {

void take_positions(DisplayPolyhedron& out, const Polyhedron& polyhedron) {
  const Index count = polyhedron.vertex_count();
  out.positions.resize(count);
  out.box.setEmpty();
  for (Index v = 0; v < count; ++v) {
    const Vector3& p = polyhedron.position(v);
    out.box.extend(p);
    out.positions[v] = {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
  }
}

}  // namespace

std::shared_ptr<const DisplayPolyhedron> DisplayPolyhedron::build(const Polyhedron& polyhedron,
                                                                  const Shaping& shaping,
                                                                  const Vector3& origin) {
  auto out = std::make_shared<DisplayPolyhedron>();
  const HalfEdgeMesh& topology = polyhedron.topology();
  out->origin = origin;
  take_positions(*out, polyhedron);
  out->edges.reserve(topology.edge_count());
  out->edge_kinds.reserve(topology.edge_count());
  for (Index e = 0; e < topology.edge_count(); ++e) {
    const Index h = topology.half_edge_of_edge(e);
    out->edges.push_back({topology.origin(h), topology.target(h)});
    EdgeKind kind = EdgeKind::plain;
    if (topology.is_border_edge(e))
      kind = EdgeKind::boundary;
    else if (!shaping.crease.empty() && shaping.crease.contains(polyhedron.edge_id(e)))
      kind = EdgeKind::crease;
    out->edge_kinds.push_back(kind);
  }
  for (Index f = 0; f < topology.face_count(); ++f) {
    const auto vertices = topology.face_vertices(f);
    out->face_vertices.insert(out->face_vertices.end(), vertices.begin(), vertices.end());
    out->face_offsets.push_back(static_cast<Index>(out->face_vertices.size()));
  }
  out->vertex_ids.reserve(polyhedron.vertex_count());
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) out->vertex_ids.push_back(polyhedron.vertex_id(v));
  out->face_ids.reserve(polyhedron.face_count());
  for (Index f = 0; f < polyhedron.face_count(); ++f) out->face_ids.push_back(polyhedron.face_id(f));
  return out;
}

std::shared_ptr<const DisplayPolyhedron> DisplayPolyhedron::moved(const Polyhedron& polyhedron) const {
  HARIKO_ASSERT(polyhedron.vertex_count() == positions.size(), "the topology must be the same");
  auto out = std::make_shared<DisplayPolyhedron>(*this);
  take_positions(*out, polyhedron);
  return out;
}

}  // namespace hariko
