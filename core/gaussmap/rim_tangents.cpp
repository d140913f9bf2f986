#include "core/gaussmap/rim_tangents.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/assert.hpp"
#include "core/gaussmap/outlines/loop_curve.hpp"
#include "core/network/kept_form.hpp"
#include "core/network/network_system.hpp"

namespace hariko {
namespace {

std::vector<std::vector<Index>> border_loops(const HalfEdgeMesh& mesh) {
  std::vector<std::vector<Index>> out;
  std::vector<char> done(mesh.vertex_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (done[v] || !mesh.is_border_vertex(v)) continue;
    out.emplace_back();
    for (Index w = v; !done[w]; w = mesh.target(mesh.outgoing(w))) {
      done[w] = 1;
      out.back().push_back(w);
    }
  }
  return out;
}

/// Normal of the common plane of the points; zero where there is none.
Vector3 common_plane(const std::vector<Vector3>& points) {
  Vector3 middle = Vector3::Zero(), area = Vector3::Zero();
  for (const Vector3& point : points) middle += point / double(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    area += (points[i] - middle).cross(points[(i + 1) % points.size()] - middle);
  area.stableNormalize();
  for (const Vector3& point : points)
    if (!(std::abs((point - middle).dot(area)) <= 1e-9 * (point - middle).norm())) return Vector3::Zero();
  return area;
}

/// Intersection of the tangent plane with the loop's plane, if that is near the curve's direction; normals
/// that are not perpendicular to a flat loop force the tangent out of its plane.
Vector3 in_plane(const Vector3& direction, const Vector3& axis, const Vector3& normal) {
  constexpr double near = 0.996;  // cosine of 5 degrees
  Vector3 line = axis.cross(normal);
  if (line.norm() < 1e-6) return direction;  // the planes coincide, or there is no loop plane
  line.normalize();
  if (line.dot(direction) < 0) line = -line;
  return line.dot(direction) > near ? line : direction;
}

/// Length of the Bezier tangent of a circular arc over a chord: a third of the chord over the squared cosine
/// of a quarter of the arc's angle; the tangent makes half that angle with the chord.
double arc_tangent_length(const Vector3& direction, const Vector3& chord) {
  const double length = chord.norm(), cosine = std::abs(direction.dot(chord)) / length;
  return 2 * length / (3 * (1 + cosine));
}

/// Kept form of a vertex that offsets its basis vectors by `offset`, and changes nothing else.
KeptForm form_with_offset(const Polyhedron& polyhedron, const VertexFrames& frames, Index v,
                          std::span<const Vector3> offset) {
  KeptForm out;
  const std::vector<FanEnd> fan = fan_ends(polyhedron.topology(), v);
  const std::vector<Matrix3> directions = edge_directions(polyhedron, v, fan);
  for (std::size_t k = 0; k < fan.size(); ++k) {
    if (directions[k].isZero(0)) continue;
    KeptForm::Edge edge;
    edge.to = polyhedron.vertex_id(fan[k].other);
    edge.offset = directions[k].transpose() * image_of_unit(frames, fan[k].end, offset);
    out.edges.push_back(edge);
  }
  std::sort(out.edges.begin(), out.edges.end(), [](const auto& a, const auto& b) { return a.to < b.to; });
  return out;
}

}  // namespace

std::vector<RimTangent> rim_directions(const Polyhedron& polyhedron, const Shaping& shaping) {
  std::vector<RimTangent> out;
  for (const std::vector<Index>& loop : border_loops(polyhedron.topology())) {
    OutlineLoop outline;
    for (const Index v : loop) {
      outline.points.push_back(polyhedron.position(v));
      const Pin* pin = shaping.pin.find(polyhedron.vertex_id(v));
      HARIKO_ASSERT(pin && pin->kind == Pin::Kind::normal, "rims have pinned normals");
      outline.normals.push_back(pin->vectors[0].stableNormalized());
    }
    const Vector3 axis = common_plane(outline.points);
    const LoopCurve curve(outline);
    const std::size_t count = loop.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3& normal = outline.normals[i];
      Vector3 direction = curve.at(i, 0).tangent;
      direction = in_plane((direction - direction.dot(normal) * normal).normalized(), axis, normal);
      out.push_back(
          {loop[i], direction,
           arc_tangent_length(direction, outline.points[(i + 1) % count] - outline.points[i]),
           arc_tangent_length(direction, outline.points[i] - outline.points[(i + count - 1) % count])});
    }
  }
  return out;
}

Result<FlatMap<VertexId, Pin>> rim_tangents(const Polyhedron& polyhedron, const Shaping& shaping) {
  const auto network = NetworkSystem::assemble(polyhedron, shaping);
  if (!network) return network.error();
  const auto basis = network->solve(polyhedron.positions(), {}).basis;
  FlatMap<VertexId, Pin> out;
  for (const RimTangent& rim : rim_directions(polyhedron, shaping)) {
    // The first basis vector of a smooth border vertex is the tangent along it (kuriyama.md 2.1).
    const Index first = network->frames().basis_begin[rim.vertex],
                end = network->frames().basis_begin[rim.vertex + 1];
    HARIKO_ASSERT(network->frames().kind[rim.vertex] == FrameKind::sharp_line, "rims are smooth");
    Pin pin{Pin::Kind::tangents, std::vector<Vector3>(basis.begin() + first, basis.begin() + end)};
    pin.vectors[0] = (rim.ahead + rim.behind) / 2 * rim.direction;
    out.set(polyhedron.vertex_id(rim.vertex), std::move(pin));
  }
  return out;
}

Result<FlatMap<VertexId, KeptForm>> rim_forms(const Polyhedron& polyhedron, const Shaping& shaping) {
  const auto network = NetworkSystem::assemble(polyhedron, shaping, {Frames::metric});
  if (!network) return network.error();
  const VertexFrames& frames = network->frames();
  const std::vector<Vector3> basis = network->solve(polyhedron.positions(), {}).basis;
  // Forms are independent of each other: each offsets the network's basis vectors of its own vertex.
  std::vector<Vector3> offset(basis.size(), Vector3::Zero());
  const std::vector<RimTangent> rims = rim_directions(polyhedron, shaping);
  for (const RimTangent& rim : rims) {
    HARIKO_ASSERT(frames.kind[rim.vertex] == FrameKind::sharp_line, "rims are smooth");
    const std::vector<FanEnd> fan = fan_ends(polyhedron.topology(), rim.vertex);
    const double ahead = rim.ahead / frames.length[fan.front().end],
                 behind = rim.behind / frames.length[fan.back().end];
    const Index along = frames.basis_begin[rim.vertex];
    offset[along] = (ahead + behind) / 2 * rim.direction - basis[along];
  }
  FlatMap<VertexId, KeptForm> out;
  for (const RimTangent& rim : rims)
    out.set(polyhedron.vertex_id(rim.vertex), form_with_offset(polyhedron, frames, rim.vertex, offset));
  return out;
}

}  // namespace hariko
