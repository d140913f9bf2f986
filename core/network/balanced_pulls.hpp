#pragma once

// BalancedPulls: tangents at sharp turns of a network by measure (kuriyama.md section 12.4).

#include <array>
#include <span>
#include <vector>

#include "core/network/vertex_frames.hpp"

namespace hariko {

struct NetworkWeights;

/// Pulls of the edges and split edges round a smooth vertex, where a turn is so sharp that two opposite ones
/// go the same way: the one that counts more would pull the other's tangent backwards, and the surface folds.
/// There only the odd part of the directions round the vertex counts, half the difference of a direction and
/// the opposite one, so that the tangent is square to the bisector whatever the lengths are. In a plane a
/// direction is its own odd part and nothing changes. Values for frozen frames; linear in the positions.
class BalancedPulls {
 public:
  /// Nothing is balanced.
  BalancedPulls() = default;
  /// `beta`: per edge. The frames must be by measure. O(edges).
  BalancedPulls(const HalfEdgeMesh& mesh, const VertexFrames& frames, const NetworkWeights& weights,
                std::span<const double> beta, std::span<const Vector3> positions);

  /// Parts, 0 .. 1, of the coupling between both ends of an edge, and between a split edge's vertex and its
  /// split point, that balancing leaves: what pulls from afar cannot be balanced at the vertex.
  double of_edge(Index edge) const { return edge_coupling_.empty() ? 1 : edge_coupling_[edge]; }
  double of_split_edge(Index half_edge) const { return ray_coupling_.empty() ? 1 : ray_coupling_[half_edge]; }

  /// Adds what balancing changes in the right-hand side at these vertices.
  void add_right_side(const HalfEdgeMesh& mesh, std::span<const Index> vertices,
                      std::span<const Vector3> positions, std::vector<Vector3>& b) const;

 private:
  /// An edge or a split edge as seen from a vertex.
  struct Direction {
    TangentCoefficients tangent;
    Index half_edge = no_index;  ///< leaves the vertex; a split edge lies on its left
    bool split = false;
    double length = 1, angle = 0;  ///< in space; in the fan
    double weight = 0;
    /// The opposite unit vector is the sum of these two neighbours' unit vectors times the parts.
    std::array<std::size_t, 2> opposite{};
    std::array<double, 2> part{};
  };
  struct Vertex {
    Index vertex;
    double share;  ///< of the odd part, above 0
    std::size_t begin, end;
  };
  class Fan;

  static Vector3 reach(const HalfEdgeMesh& mesh, std::span<const Vector3> positions,
                       const Direction& direction);

  std::vector<double> edge_coupling_, ray_coupling_;  ///< per edge, per half-edge
  std::vector<Index> place_;                          ///< per vertex: in vertices_, or none
  std::vector<Vertex> vertices_;                      ///< balanced ones only
  std::vector<Direction> directions_;
};

}  // namespace hariko
