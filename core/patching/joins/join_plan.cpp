#include "core/patching/joins/join_plan.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/patching/joins/join_frame.hpp"

namespace hariko {

namespace {

constexpr double smallest_sine = 0.1;  ///< least sine of the angle of a corner between two given sides

Message at_vertex(Code code, Index v, const Polyhedron& polyhedron, std::string text, std::string remedy) {
  return make_error(code, std::move(text), std::move(remedy), element_of(polyhedron.vertex_id(v)));
}

constexpr const char* let_patch_adapt =
    "Let one of the patches adapt to the surface, or join one of the edges by position only.";

}  // namespace

JoinFrame join_frame(const Join& join, bool at_origin) {
  JoinFrame out;
  const auto& p = join.curve;
  const auto& q = join.row;
  out.tangent = at_origin ? p[1] - p[0] : p[2] - p[3];
  out.along = at_origin ? out.tangent : Vector3(-out.tangent);
  if (join.continuity == Continuity::g0) return out;
  out.across = at_origin ? q[0] - p[0] : q[3] - p[3];
  // The surface lies to the left of its border and the patch to the right.
  out.normal = out.across.cross(out.along);
  const double area = out.normal.norm();
  if (area > 1e-9 * out.across.norm() * out.along.norm() && area > 0)
    out.normal /= area;
  else
    out.normal.setZero();
  return out;
}

std::string JoinPlan::name(Index v) const {
  return std::to_string(polyhedron_->vertex_id(v).value);
}

Result<JoinPlan> JoinPlan::make(const Polyhedron& polyhedron, const Shaping& shaping,
                                std::vector<Join> joins) {
  JoinPlan plan;
  const HalfEdgeMesh& mesh = polyhedron.topology();
  std::sort(joins.begin(), joins.end(),
            [](const Join& a, const Join& b) { return a.half_edge < b.half_edge; });
  plan.joins_ = std::move(joins);
  for (std::size_t j = 0; j < plan.joins_.size(); ++j) {
    const Index h = plan.joins_[j].half_edge;
    HARIKO_ASSERT(h < mesh.half_edge_count() && mesh.twin(h) == no_index, "only border edges are joined");
    HARIKO_ASSERT(j == 0 || plan.joins_[j - 1].half_edge != h, "an edge is joined once");
    plan.vertices_[mesh.origin(h)].out = int(j);
    plan.vertices_[mesh.target(h)].in = int(j);
  }
  if (auto failed = plan.move_vertices(polyhedron)) return *failed;
  for (auto& [v, vertex] : plan.vertices_) {
    if (shaping.pin.find(polyhedron.vertex_id(v)) != nullptr)
      return at_vertex(e_join_pinned, v, polyhedron,
                       "Vertex " + plan.name(v) + " has a pin, but a patch is joined to its edge.",
                       "Release the pin, or release the joined edge.");
    const Index first = mesh.outgoing(v);
    for (Index h = first; h != no_index; h = mesh.rotate(h)) {
      ++vertex.corners;
      if (h != first && shaping.crease.find(polyhedron.edge_id(mesh.edge(h))) != nullptr) ++vertex.creases;
    }
    if (auto failed = plan.check_vertex(v, vertex)) return *failed;
    if (auto failed = plan.request_frame(v, vertex)) return *failed;
  }
  return plan;
}

std::optional<Message> JoinPlan::move_vertices(const Polyhedron& polyhedron) {
  polyhedron_ = polyhedron;
  if (joins_.empty()) return std::nullopt;
  Eigen::AlignedBox3d box;
  for (Index v = 0; v < polyhedron.vertex_count(); ++v)
    if (polyhedron.topology().outgoing(v) != no_index) box.extend(polyhedron.position(v));
  for (const Join& join : joins_)
    for (const Vector3& point : join.curve) box.extend(point);
  const double tolerance = join_tolerance * box.diagonal().norm();
  std::vector<Index> moved;
  std::vector<Vector3> positions;
  for (const auto& [v, vertex] : vertices_) {
    moved.push_back(v);
    positions.push_back(vertex.out >= 0 ? joins_[std::size_t(vertex.out)].curve[0]
                                        : joins_[std::size_t(vertex.in)].curve[3]);
    if (vertex.out < 0 || vertex.in < 0) continue;
    if ((joins_[std::size_t(vertex.in)].curve[3] - positions.back()).norm() <= tolerance) continue;
    return at_vertex(
        e_join_gap, v, polyhedron,
        "The sides joined to the two border edges at vertex " + name(v) + " do not end in the same point.",
        "Bring the ends of the patches together, or release one of the edges.");
  }
  auto placed = polyhedron.with_positions(moved, positions);
  if (!placed) return placed.error();
  polyhedron_ = std::move(placed).value();
  return std::nullopt;
}

std::optional<Message> JoinPlan::check_vertex(Index v, const Vertex& vertex) {
  for (const auto& [join, at_origin] : {std::pair{vertex.out, true}, std::pair{vertex.in, false}}) {
    if (join < 0) continue;
    const JoinFrame frame = join_frame(joins_[std::size_t(join)], at_origin);
    const bool smooth = joins_[std::size_t(join)].continuity != Continuity::g0;
    if (!(frame.tangent.norm() > 0) || (smooth && frame.normal.isZero(0)))
      return at_vertex(e_join_degenerate, v, *polyhedron_,
                       "The side joined at vertex " + name(v) +
                           (frame.tangent.norm() > 0 ? " has no tangent plane at its end."
                                                     : " has no tangent at its end."),
                       "Move the control points beside the corner of the patch apart.");
  }
  if (vertex.out < 0 || vertex.in < 0 || vertex.creases > 1) return std::nullopt;
  const JoinFrame out = join_frame(joins_[std::size_t(vertex.out)], true),
                  in = join_frame(joins_[std::size_t(vertex.in)], false);
  const auto leaves = [](const Vector3& normal, const Vector3& tangent) {
    return std::abs(normal.dot(tangent)) > join_tolerance * tangent.norm();
  };
  bool coplanar = true;
  if (!out.normal.isZero(0) && !in.normal.isZero(0))
    coplanar = (out.normal - in.normal).norm() <= join_tolerance;
  else if (vertex.creases == 0)
    coplanar = !leaves(out.normal, in.tangent) && !leaves(in.normal, out.tangent);
  if (coplanar) return std::nullopt;
  return at_vertex(e_join_corner, v, *polyhedron_,
                   "The patches joined at vertex " + name(v) + " have no common tangent plane there.",
                   let_patch_adapt);
}

Vector3 JoinPlan::face_normal(Index v) const {
  const HalfEdgeMesh& mesh = polyhedron_->topology();
  Vector3 sum = Vector3::Zero();
  const Vector3& p = polyhedron_->position(v);
  for (Index h = mesh.outgoing(v); h != no_index; h = mesh.rotate(h)) {
    const Index f = mesh.face(h);
    Vector3 newell = Vector3::Zero();
    for (Index k = mesh.face_begin(f); k < mesh.face_end(f); ++k)
      newell += (polyhedron_->position(mesh.origin(k)) - p).cross(polyhedron_->position(mesh.target(k)) - p);
    sum += newell;
  }
  return sum;
}

std::optional<Message> JoinPlan::request_frame(Index v, const Vertex& vertex) {
  if (vertex.out < 0 || vertex.in < 0 || vertex.creases > 0) return std::nullopt;
  const JoinFrame out = join_frame(joins_[std::size_t(vertex.out)], true),
                  in = join_frame(joins_[std::size_t(vertex.in)], false);
  const double longer = std::max(out.tangent.norm(), in.tangent.norm());
  if ((out.tangent + in.tangent).norm() <= join_tolerance * longer) {
    requests_.push_back({v, true, 0});
    return std::nullopt;
  }
  const Vector3 turn = out.tangent.cross(in.tangent);
  Vector3 normal = !out.normal.isZero(0) ? out.normal : in.normal;
  if (normal.isZero(0)) normal = turn.dot(face_normal(v)) >= 0 ? turn : Vector3(-turn);
  double opening = std::atan2(std::copysign(turn.norm(), turn.dot(normal)), out.tangent.dot(in.tangent));
  if (opening < 0) opening += 2 * std::numbers::pi;
  if (std::abs(std::sin(opening)) < smallest_sine)
    return at_vertex(
        e_join_angle, v, *polyhedron_,
        "The sides joined at vertex " + name(v) + " meet almost in one line, but not as one smooth curve.",
        "Make their end tangents opposite and equally long, or turn one of them.");
  if (opening > std::numbers::pi && vertex.corners < 2)
    return at_vertex(
        e_join_angle, v, *polyhedron_,
        "The surface turns round vertex " + name(v) + " by more than a half turn, which one face cannot do.",
        "Add an edge that ends in the vertex.");
  requests_.push_back({v, false, opening});
  return std::nullopt;
}

std::vector<Index> JoinPlan::half_edges() const {
  std::vector<Index> out;
  for (const Join& join : joins_) out.push_back(join.half_edge);
  return out;
}

bool JoinPlan::any_smooth() const {
  return std::any_of(joins_.begin(), joins_.end(),
                     [](const Join& join) { return join.continuity != Continuity::g0; });
}

std::vector<bool> JoinPlan::smooth_sides() const {
  std::vector<bool> out;
  for (const Join& join : joins_) {
    if (join.continuity == Continuity::g0) continue;
    if (out.empty()) out.assign(polyhedron_->topology().half_edge_count(), false);
    out[join.half_edge] = true;
  }
  return out;
}

bool JoinPlan::same_structure(const JoinPlan& other) const {
  const auto same = [](const Join& a, const Join& b) {
    return a.half_edge == b.half_edge && a.continuity == b.continuity && a.patch_follows == b.patch_follows;
  };
  return std::equal(joins_.begin(), joins_.end(), other.joins_.begin(), other.joins_.end(), same) &&
         requests_ == other.requests_;
}

}  // namespace hariko
