#include "core/network/curve_ties.hpp"

#include <algorithm>
#include <cmath>

#include "core/network/network_rays.hpp"

namespace hariko {

namespace {

/// Ratios of a curve's length to the width of the polyhedron beside it: where ties begin (beside a short
/// side, past a close corner), and where they stop growing. On a cylinder of 32 sides as high as wide, whose
/// sides are ten times as long as the rim's edges, nothing is tied.
constexpr double first_beside = 12, first_corner = 8, last_ratio = 1000;
/// Weights of ties, relative to the other energies at a vertex.
constexpr double beside_weight = 0.02, corner_weight = 1;

/// Strength of a tie: grows smoothly from zero, and for large ratios like the ratio itself, as the torsional
/// stiffness of a strip grows with its length over its width.
double strength(double ratio, double first) {
  const double r = std::min(ratio, last_ratio);
  return r > first ? (r - first) * (r - first) / r : 0.0;
}

TangentCoefficients times(double factor, TangentCoefficients tangent) {
  for (double& c : tangent.c) c *= factor;
  return tangent;
}

/// Sum of the weights that act at each vertex, per unit length of its fan.
std::vector<double> pulls(const HalfEdgeMesh& mesh, const VertexFrames& frames, const NetworkWeights& weights,
                          std::span<const double> beta) {
  std::vector<double> out(mesh.vertex_count(), 0.0);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.half_edge_of_edge(e);
    const double weight = weights.edge[e] * beta[e];
    out[mesh.origin(h)] += weight * frames.length[2 * h] * frames.length[2 * h];
    out[mesh.target(h)] += weight * frames.length[2 * h + 1] * frames.length[2 * h + 1];
  }
  return out;
}

}  // namespace

CurveTies::CurveTies(const HalfEdgeMesh& mesh, const VertexFrames& frames, const NetworkWeights& weights,
                     std::span<const double> beta, std::span<const Vector3> positions)
    : seen_(mesh.vertex_count()) {
  const std::vector<double> pull = pulls(mesh, frames, weights, beta);
  tie_beside_short_sides(mesh, frames, pull);
  tie_to_close_corners(mesh, frames, pull, positions);
  if (ties_.empty()) seen_.clear();
}

void CurveTies::add(const Tie& tie, Index first, Index second) {
  if (!(tie.weight > 0)) return;
  seen_[first].push_back({ties_.size(), 0});
  seen_[second].push_back({ties_.size(), 1});
  ties_.push_back(tie);
}

/// Ties the tangents, less their chords, with which the two sides beside a far shorter one leave it.
void CurveTies::tie_beside_short_sides(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                                       std::span<const double> pull) {
  const std::vector<double>& length = frames.charts.edge_length;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index before = mesh.previous(h), after = mesh.next(h), v = mesh.origin(h), w = mesh.target(h);
    const double beside = std::min(length[mesh.edge(before)], length[mesh.edge(after)]);
    const double own = length[mesh.edge(h)];
    if (!(beside > first_beside * own)) continue;
    const double ratio = own * last_ratio > beside ? beside / own : last_ratio;
    Tie tie;
    tie.end = {frames.ends[2 * before + 1], times(-1, frames.ends[2 * after])};
    tie.weight =
        2 * beside_weight * strength(ratio, first_beside) * std::min(pull[v], pull[w]) / (beside * beside);
    tie.vertex = {mesh.origin(before), v, mesh.target(after), w};
    tie.factor = {1.0 / 3, -1.0 / 3, -1.0 / 3, 1.0 / 3};
    add(tie, v, w);
  }
}

/// Ties the bulge of a side over the projection of a close corner: a t + b t', with the tangents at both of
/// its ends. The position of the projection decides a and b; a^2 + b^2 = 1.
void CurveTies::tie_to_close_corners(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                                     std::span<const double> pull, std::span<const Vector3> positions) {
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index v = mesh.origin(h), w = mesh.target(h);
    const Vector3 chord = positions[w] - positions[v];
    const double length = chord.norm();
    if (!(length > 0)) continue;
    for (Index k = mesh.next(mesh.next(h)); k != h; k = mesh.next(k)) {
      const Vector3 arm = positions[mesh.origin(k)] - positions[v];
      const double t = arm.dot(chord) / (length * length);
      if (!(t > 0 && t < 1)) continue;
      const double distance = (arm - t * chord).norm(), width = length * 4 * t * (1 - t);
      if (!(width > first_corner * distance)) continue;
      const double size = std::hypot(1 - t, t), a = (1 - t) / size, b = t / size;
      Tie tie;
      tie.end = {times(a, frames.ends[2 * h]), times(b, frames.ends[2 * h + 1])};
      tie.weight = 2 * corner_weight *
                   strength(distance * last_ratio > width ? width / distance : last_ratio, first_corner) *
                   std::min(pull[v], pull[w]) / (length * length);
      tie.vertex = {v, w, v, w};
      tie.factor = {-(a - b) / 3, (a - b) / 3, 0, 0};
      add(tie, v, w);
    }
  }
}

void CurveTies::add_diagonal(Index v, Index first, Eigen::MatrixXd& block) const {
  if (empty()) return;
  for (const Seen& seen : seen_[v]) {
    const TangentCoefficients& end = ties_[seen.tie].end[seen.own];
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 2; ++b)
        if (end.basis[a] != no_index && end.basis[b] != no_index)
          block(end.basis[a] - first, end.basis[b] - first) += ties_[seen.tie].weight * end.c[a] * end.c[b];
  }
}

void CurveTies::add_product(Index v, const std::vector<Vector3>& x, std::vector<Vector3>& y) const {
  if (empty()) return;
  for (const Seen& seen : seen_[v]) {
    const Tie& tie = ties_[seen.tie];
    const Vector3 sum = tangent_image(tie.end[0], x) + tangent_image(tie.end[1], x);
    add_to_basis(tie.end[seen.own], tie.weight * sum, y);
  }
}

void CurveTies::add_right_side(std::span<const Index> vertices, std::span<const Vector3> positions,
                               std::vector<Vector3>& b) const {
  if (empty()) return;
  for (const Index v : vertices)
    for (const Seen& seen : seen_[v]) {
      const Tie& tie = ties_[seen.tie];
      // Relative to the vertex, so that no digits are lost far from the origin: the factors add up to zero.
      Vector3 goal = Vector3::Zero();
      for (std::size_t i = 0; i < tie.vertex.size(); ++i)
        goal += tie.factor[i] * (positions[tie.vertex[i]] - positions[v]);
      add_to_basis(tie.end[seen.own], tie.weight * goal, b);
    }
}

}  // namespace hariko
