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

void take_shaping(DisplayPolyhedron& out, const Polyhedron& polyhedron, const Shaping& shaping) {
  const HalfEdgeMesh& topology = polyhedron.topology();
  out.alpha.assign(polyhedron.vertex_count(), 0.0F);
  out.corners.clear();
  out.smooth.clear();
  out.pinned.clear();
  for (Index v = 0; v < polyhedron.vertex_count(); ++v) {
    const VertexId id = polyhedron.vertex_id(v);
    out.alpha[v] = static_cast<float>(shaping.alpha.get_or(id, 0));
    const VertexTag tag = shaping.tag.get_or(id, VertexTag::automatic);
    if (tag == VertexTag::corner) out.corners.push_back(v);
    if (tag == VertexTag::smooth) out.smooth.push_back(v);
    if (shaping.pin.contains(id)) out.pinned.push_back(v);
  }
  out.beta.assign(topology.edge_count(), 1.0F);
  out.edge_kinds.assign(topology.edge_count(), EdgeKind::plain);
  for (Index e = 0; e < topology.edge_count(); ++e) {
    const EdgeId id = polyhedron.edge_id(e);
    out.beta[e] = static_cast<float>(shaping.beta.get_or(id, 1));
    if (topology.is_border_edge(e))
      out.edge_kinds[e] = EdgeKind::boundary;
    else if (shaping.crease.contains(id))
      out.edge_kinds[e] = EdgeKind::crease;
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
  for (Index e = 0; e < topology.edge_count(); ++e) {
    const Index h = topology.half_edge_of_edge(e);
    out->edges.push_back({topology.origin(h), topology.target(h)});
  }
  take_shaping(*out, polyhedron, shaping);
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

std::shared_ptr<const DisplayPolyhedron> DisplayPolyhedron::shaped(const Polyhedron& polyhedron,
                                                                   const Shaping& shaping) const {
  HARIKO_ASSERT(polyhedron.vertex_count() == positions.size(), "the topology must be the same");
  auto out = std::make_shared<DisplayPolyhedron>(*this);
  take_shaping(*out, polyhedron, shaping);
  return out;
}

std::shared_ptr<const DisplayPolyhedron> DisplayPolyhedron::moved(const Polyhedron& polyhedron) const {
  HARIKO_ASSERT(polyhedron.vertex_count() == positions.size(), "the topology must be the same");
  auto out = std::make_shared<DisplayPolyhedron>(*this);
  take_positions(*out, polyhedron);
  return out;
}

std::shared_ptr<const DisplayPolyhedron> cage_of(const Object& object) {
  const Polyhedron* cage = object.cage();
  if (!cage) return nullptr;
  const PolyhedronSource* source = object.polyhedron();
  return DisplayPolyhedron::build(*cage, source ? *source->shaping : Shaping{}, object.cage_origin());
}

}  // namespace hariko
