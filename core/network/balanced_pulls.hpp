#pragma once

// BalancedPulls: balanced tangents at sharp turns of a network in metric frames (kuriyama.md section 12.4).

#include <array>
#include <span>
#include <vector>

#include "core/network/vertex_frames.hpp"

namespace hariko {

struct NetworkWeights;

/// Balanced pulls of the edges and split edges around a smooth vertex. Where a turn is so sharp that two
/// opposite directions point nearly the same way, the one with the larger weight would pull the other's
/// tangent backwards, and the surface would fold. There only the odd part of the directions around the vertex
/// acts, half the difference of a direction and the opposite one, so that the tangent is at right angles to
/// the bisector whatever the lengths are. In a plane a direction is its own odd part and nothing changes.
/// Computed for fixed frames; linear in the positions.
class BalancedPulls {
 public:
  /// Balances no vertex.
  BalancedPulls() = default;
  /// Finds the sharp turns. `beta`: edge tension, per edge. The frames must be metric. O(edges).
  BalancedPulls(const HalfEdgeMesh& mesh, const VertexFrames& frames, const NetworkWeights& weights,
                std::span<const double> beta, std::span<const Vector3> positions);

  /// Remaining parts, 0 .. 1, of the coupling between the two ends of an edge, and between a split edge's
  /// vertex and its split point: the far end's pull cannot be balanced at the vertex.
  double of_edge(Index edge) const { return edge_coupling_.empty() ? 1 : edge_coupling_[edge]; }
  double of_split_edge(Index half_edge) const { return ray_coupling_.empty() ? 1 : ray_coupling_[half_edge]; }

  /// Adds the change of the right-hand side due to balancing at these vertices.
  void add_right_side(const HalfEdgeMesh& mesh, std::span<const Index> vertices,
                      std::span<const Vector3> positions, std::vector<Vector3>& b) const;

 private:
  /// Edge or split edge as seen from a vertex.
  struct Direction {
    TangentCoefficients tangent;
    Index half_edge = no_index;  ///< leaves the vertex; a split edge lies on its left
    bool split = false;
    double length = 1, angle = 0;  ///< length in space; angle in the fan
    double weight = 0;
    /// The opposite unit vector is the sum of the unit vectors of these two neighbours times `part`.
    std::array<std::size_t, 2> opposite{};
    std::array<double, 2> part{};
  };
  struct Vertex {
    Index vertex;
    double share;  ///< share of balancing, > 0
    std::size_t begin, end;
  };
  class Fan;

  static Vector3 reach(const HalfEdgeMesh& mesh, std::span<const Vector3> positions,
                       const Direction& direction);

  std::vector<double> edge_coupling_, ray_coupling_;  ///< per edge, per half-edge
  std::vector<Index> place_;                          ///< per vertex: its place in vertices_, or no_index
  std::vector<Vertex> vertices_;                      ///< balanced ones only
  std::vector<Direction> directions_;
};

}  // namespace hariko
