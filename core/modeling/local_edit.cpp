#include "core/modeling/local_edit.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "core/document/edits.hpp"
#include "core/modeling/surface_input.hpp"
#include "core/network/network_system.hpp"

namespace hariko {
namespace {

/// The vertex's neighbours in the order of its fan: tangent bases of equal fans mean the same.
std::vector<VertexId> fan_of(const Polyhedron& polyhedron, Index v) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<VertexId> out;
  const Index first = mesh.outgoing(v);
  for (Index h = first; h != no_index;) {
    out.push_back(polyhedron.vertex_id(mesh.target(h)));
    const Index following = mesh.rotate(h);
    if (following == no_index) out.push_back(polyhedron.vertex_id(mesh.origin(mesh.previous(h))));
    h = following == first ? no_index : following;
  }
  return out;
}

}  // namespace

std::vector<VertexId> vertices_around(const Polyhedron& polyhedron, std::span<const VertexId> vertices) {
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::vector<VertexId> out(vertices.begin(), vertices.end());
  for (const VertexId id : vertices) {
    const Index v = polyhedron.find(id);
    if (v == no_index) continue;
    const Index first = mesh.outgoing(v);
    for (Index h = first; h != no_index;) {
      for (const Index corner : mesh.face_vertices(mesh.face(h))) out.push_back(polyhedron.vertex_id(corner));
      const Index following = mesh.rotate(h);
      h = following == first ? no_index : following;
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

Result<PolyhedronSource> freeze_tangents(const PolyhedronSource& source, std::span<const VertexId> vertices) {
  const auto input = surface_input(source);
  if (!input) return input.error();
  const auto system = NetworkSystem::assemble(input->polyhedron, input->shaping);
  if (!system) return system.error();
  const std::vector<Vector3> positions = input->polyhedron.positions();
  const auto solution = system->solve(positions, {});
  const Network network = system->network(solution, positions);
  const VertexFrames& frames = system->frames();

  Shaping shaping = *source.shaping;
  for (const VertexId id : vertices) {
    const Index own = source.polyhedron.find(id), v = input->polyhedron.find(id);
    if (own == no_index)
      return make_error(e_unknown_element, "The vertex does not exist.", "Select it again.", element_of(id));
    if (source.polyhedron.topology().outgoing(own) == no_index || v == no_index)
      return make_error(e_no_tangents, "The vertex has no face, so it has no tangents.",
                        "Choose a vertex of a face.", element_of(id));
    const Pin* pinned = shaping.pin.find(id);
    if (pinned && pinned->kind == Pin::Kind::tangents) continue;
    Pin pin;
    if (fan_of(source.polyhedron, own) == fan_of(input->polyhedron, v)) {
      pin.kind = Pin::Kind::tangents;
      for (Index b = frames.basis_begin[v]; b < frames.basis_begin[v + 1]; ++b)
        pin.vectors.push_back(solution.basis[b]);
    } else if (network.normal[v] != Vector3::Zero()) {
      pin.vectors = {network.normal[v]};
    } else {
      continue;  // a corner of several planes: nothing in common to fix
    }
    shaping.pin.set(id, std::move(pin));
  }
  PolyhedronSource out = source;
  out.shaping = std::move(shaping);
  return out;
}

PolyhedronSource with_turned_tangents(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                      const Matrix3& linear) {
  HARIKO_ASSERT(linear.determinant() != 0, "tangents are turned and stretched, not flattened");
  const Matrix3 of_normals = linear.inverse().transpose();
  Shaping shaping = *source.shaping;
  for (const VertexId id : vertices) {
    const Pin* pinned = shaping.pin.find(id);
    if (!pinned) continue;
    Pin pin = *pinned;
    for (Vector3& vector : pin.vectors)
      vector = (pin.kind == Pin::Kind::normal ? of_normals : linear) * vector;
    shaping.pin.set(id, std::move(pin));
  }
  PolyhedronSource out = source;
  out.shaping = std::move(shaping);
  return out;
}

}  // namespace hariko
