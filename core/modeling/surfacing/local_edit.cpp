#include "core/modeling/surfacing/local_edit.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "core/base/index_list.hpp"
#include "core/base/solvers/dense_solver.hpp"
#include "core/document/edits/edits.hpp"
#include "core/modeling/surfacing/surface_input.hpp"
#include "core/network/network_system.hpp"

namespace hariko {
namespace {

/// The vertex's neighbours in the order of its fan: tangent bases mean the same for equal fans.
std::vector<VertexId> fan_of(const Polyhedron& polyhedron, Index v) {
  std::vector<VertexId> out;
  for (const FanEnd& each : fan_ends(polyhedron.topology(), v))
    out.push_back(polyhedron.vertex_id(each.other));
  return out;
}

/// Basis vectors whose fan of equal angles comes nearest to the network's tangents at a vertex; pinned
/// vertices have such fans.
std::vector<Vector3> nearest_basis(const HalfEdgeMesh& mesh, const VertexFrames& equal,
                                   const Network& network, Index v) {
  const Index begin = equal.basis_begin[v], count = equal.basis_begin[v + 1] - begin;
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(count, count), right = Eigen::MatrixXd::Zero(count, 3);
  const auto add = [&](const TangentCoefficients& end, const Vector3& tangent) {
    for (std::size_t a = 0; a < 2; ++a) {
      if (end.basis[a] == no_index) continue;
      right.row(end.basis[a] - begin) += end.c[a] * tangent.transpose();
      for (std::size_t b = 0; b < 2; ++b)
        if (end.basis[b] != no_index)
          square(end.basis[a] - begin, end.basis[b] - begin) += end.c[a] * end.c[b];
    }
  };
  for (const FanEnd& each : fan_ends(mesh, v))
    add(equal.ends[each.end], (each.end % 2 == 0 ? network.start : network.end)[each.end / 2]);
  std::vector<Vector3> out(count);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd solved = solve_symmetric(square, Eigen::VectorXd(right.col(axis)));
    for (Index b = 0; b < count; ++b) out[b][axis] = solved[b];
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
    for (const Index h : mesh.fan_corners(v))
      for (const Index corner : mesh.face_vertices(mesh.face(h))) out.push_back(polyhedron.vertex_id(corner));
  }
  sort_unique(out);
  return out;
}

Result<PolyhedronSource> freeze_tangents(const PolyhedronSource& source, std::span<const VertexId> vertices) {
  const auto input = surface_input(source);
  if (!input) return input.error();
  const bool metric = frames_in(input->mode, input->frames) == Frames::metric;
  const auto system =
      NetworkSystem::assemble(input->polyhedron, input->shaping, {metric ? Frames::metric : Frames::equal});
  if (!system) return system.error();
  const std::vector<Vector3> positions = input->polyhedron.positions();
  const auto solution = system->solve(positions, {});
  const Network network = system->network(solution, positions);
  const VertexFrames& frames = system->frames();
  std::optional<VertexFrames> equal;
  if (metric) {
    auto built = build_vertex_frames(input->polyhedron, input->shaping);
    if (!built) return built.error();
    equal = std::move(built).value();
  }

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
      if (equal)
        pin.vectors = nearest_basis(input->polyhedron.topology(), *equal, network, v);
      else
        for (Index b = frames.basis_begin[v]; b < frames.basis_begin[v + 1]; ++b)
          pin.vectors.push_back(solution.basis[b]);
    } else if (network.normal[v] != Vector3::Zero()) {
      pin.vectors = {network.normal[v]};
    } else {
      continue;  // a corner of several planes has no common tangent plane to fix
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
