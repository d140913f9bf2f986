#include "core/network/balanced_pulls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/network/network_rays.hpp"
#include "core/network/smooth_step.hpp"

namespace hariko {

namespace {

/// Cosines of the angle between a direction and the opposite one at which balancing begins and is complete:
/// 46 and 26 degrees. Right angles and the edges of pyramids and antiprisms keep their pulls.
constexpr double begins = 0.7, complete = 0.9;
/// Least edge length, relative to the mean length: shorter edges count as edges of this length.
constexpr double shortest = 1e-6;

}  // namespace

/// Edges and split edges around one smooth vertex, counter-clockwise.
class BalancedPulls::Fan {
 public:
  Fan(const HalfEdgeMesh& mesh, const VertexFrames& frames, const NetworkWeights& weights,
      std::span<const double> beta, Index v, std::vector<Direction>& room)
      : directions_(room) {
    directions_.clear();
    const double least = shortest * frames.charts.mean_length;
    double angle = 0;
    for (const Index h : mesh.fan_corners(v)) {
      const Index e = mesh.edge(h);
      Direction edge;
      edge.tangent = frames.ends[2 * h];
      edge.half_edge = h;
      edge.length = std::max(frames.charts.edge_length[e], least);
      edge.angle = angle;
      edge.weight = weights.edge[e] * beta[e];
      directions_.push_back(edge);
      directions_.push_back(split_edge(mesh, frames, weights, h, angle, least));
      angle += frames.step[h];
    }
    find_opposites();
  }

  /// Share of balancing, 0 .. 1, by the sharpest turn between opposite directions.
  double share(const HalfEdgeMesh& mesh, std::span<const Vector3> positions) const {
    std::vector<Vector3> unit;
    for (const Direction& each : directions_) unit.push_back(reach(mesh, positions, each) / each.length);
    double most = 0;
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const auto& [a, b] = directions_[i].opposite;
      const Vector3 across = directions_[i].part[0] * unit[a] + directions_[i].part[1] * unit[b];
      const double size = unit[i].norm() * across.norm();
      if (size > 0)
        most = std::max(most, smooth_step((unit[i].dot(across) / size - begins) / (complete - begins)));
    }
    return most;
  }

 private:
  static Direction split_edge(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                              const NetworkWeights& weights, Index h, double angle, double least) {
    const auto [first, second] = frames.split_factors(mesh, h);
    const Index behind = 2 * mesh.previous(h) + 1;
    const double a = first * frames.length[2 * h], b = second * frames.length[behind], step = frames.step[h];
    Direction out;
    out.half_edge = h;
    out.split = true;
    out.length = std::max(frames.charts.ray_length[h], least);
    out.angle = angle + std::atan2(b * std::sin(step), a + b * std::cos(step));
    out.weight = weights.ray[h];
    // All tangents of a smooth vertex depend on the same two basis vectors.
    out.tangent.basis = frames.ends[2 * h].basis;
    for (std::size_t i = 0; i < 2; ++i)
      out.tangent.c[i] = first * frames.ends[2 * h].c[i] + second * frames.ends[behind].c[i];
    return out;
  }

  void find_opposites() {
    constexpr double turn = 2 * std::numbers::pi;
    const std::size_t count = directions_.size();
    for (Direction& each : directions_) {
      const double goal = std::fmod(each.angle + turn / 2, turn);
      std::size_t k = 0;
      while (k + 1 < count && directions_[k + 1].angle <= goal) ++k;
      const double step = (k + 1 < count ? directions_[k + 1].angle : turn) - directions_[k].angle;
      const double into = goal - directions_[k].angle;
      each.opposite = {k, (k + 1) % count};
      each.part = {std::sin(step - into) / std::sin(step), std::sin(into) / std::sin(step)};
    }
  }

  std::vector<Direction>& directions_;
};

BalancedPulls::BalancedPulls(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                             const NetworkWeights& weights, std::span<const double> beta,
                             std::span<const Vector3> positions)
    : edge_coupling_(mesh.edge_count(), 1.0),
      ray_coupling_(mesh.half_edge_count(), 1.0),
      place_(mesh.vertex_count(), no_index) {
  std::vector<Direction> room;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (frames.kind[v] != FrameKind::smooth) continue;
    const double share = Fan(mesh, frames, weights, beta, v, room).share(mesh, positions);
    if (share == 0) continue;
    place_[v] = Index(vertices_.size());
    vertices_.push_back({v, share, directions_.size(), directions_.size() + room.size()});
    directions_.insert(directions_.end(), room.begin(), room.end());
    for (const Direction& each : room)
      (each.split ? ray_coupling_[each.half_edge] : edge_coupling_[mesh.edge(each.half_edge)]) *= 1 - share;
  }
}

Vector3 BalancedPulls::reach(const HalfEdgeMesh& mesh, std::span<const Vector3> positions,
                             const Direction& direction) {
  const Vector3& from = positions[mesh.origin(direction.half_edge)];
  if (!direction.split) return positions[mesh.target(direction.half_edge)] - from;
  const Index face = mesh.face(direction.half_edge);
  Vector3 sum = Vector3::Zero();
  for (const Index v : mesh.face_vertices(face)) sum += positions[v] - from;
  return sum / double(mesh.side_count(face));
}

void BalancedPulls::add_right_side(const HalfEdgeMesh& mesh, std::span<const Index> vertices,
                                   std::span<const Vector3> positions, std::vector<Vector3>& b) const {
  if (vertices_.empty()) return;
  std::vector<Vector3> unit;
  for (const Index v : vertices) {
    if (place_[v] == no_index) continue;
    const Vertex& vertex = vertices_[place_[v]];
    const std::span<const Direction> fan(directions_.data() + vertex.begin, vertex.end - vertex.begin);
    unit.clear();
    for (const Direction& each : fan) unit.push_back(reach(mesh, positions, each) / each.length);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const Direction& each = fan[i];
      const Vector3 even =
          0.5 * (unit[i] + each.part[0] * unit[each.opposite[0]] + each.part[1] * unit[each.opposite[1]]);
      const double coupling = each.split ? of_split_edge(each.half_edge) : of_edge(mesh.edge(each.half_edge));
      const Vector3 pull = -vertex.share * each.weight * each.length * (2 + coupling) / 3 * even;
      for (std::size_t k = 0; k < 2; ++k) b[each.tangent.basis[k]] += each.tangent.c[k] * pull;
    }
  }
}

}  // namespace hariko
