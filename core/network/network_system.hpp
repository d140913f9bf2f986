#pragma once

// NetworkSystem: the linear system of the minimum-norm network, assembled once per connectivity, tags,
// tensions and pins, solved for any positions (Kuriyama 1991, equation (5); kuriyama.md section 2.2).

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/network/balanced_pulls.hpp"
#include "core/network/curve_ties.hpp"
#include "core/network/network.hpp"
#include "core/network/network_rays.hpp"
#include "core/network/vertex_frames.hpp"

namespace hariko {

/// Condition of a join on one basis vector of a border vertex, before the network is solved: it lies in a
/// plane, or has a given value.
struct BasisCondition {
  enum class Kind : std::uint8_t { plane, fixed };
  Index vertex = no_index;
  Index basis = no_index;  ///< one of the vertex's own
  Kind kind = Kind::fixed;
  Vector3 vector = Vector3::Zero();  ///< the plane's normal, or the basis vector
};

/// Linear system of the minimum-norm network. The matrix is applied edge by edge and never stored. With the
/// block-Jacobi preconditioner its spectrum lies in [1/2, 3/2] for every mesh and every tension >= 0, so
/// conjugate gradients gain a factor 0.268 per step and need no factorisation; pins and conditions are
/// projections, which keep that bound. Metric frames add the split edges, with their split points eliminated:
/// then the spectrum was found within [0.3, 1.5], a factor 0.38 per step.
class NetworkSystem {
 public:
  /// Assembles the system. Errors: E_TENSION_NEGATIVE, E_TENSION_NONFINITE, E_CORNER_NEEDS_CREASE,
  /// E_PIN_MISMATCH, E_SINGULAR_VERTEX. Settings of elements that the polyhedron does not have are ignored.
  /// Positions matter only with metric frames. O(edges).
  static Result<NetworkSystem> assemble(const Polyhedron& polyhedron, const Shaping& shaping,
                                        const VertexFrameOptions& options = {});

  /// Replaces all conditions. Each basis vector has at most one, and its vertex has no pin. O(conditions).
  void set_conditions(std::span<const BasisCondition> conditions);

  const VertexFrames& frames() const { return frames_; }
  /// Dense copies of the tensions: beta per edge, alpha per vertex.
  const std::vector<double>& beta() const { return beta_; }
  const std::vector<double>& alpha() const { return alpha_; }
  /// True when some vertex has a `normal` pin or some basis vector is kept in a plane: then x, y and z depend
  /// on each other.
  bool couples_coordinates() const { return couples_coordinates_ || plane_conditions_; }

  struct Solution {
    std::vector<Vector3> basis;  ///< X, one per basis vector of the frames
    int iterations = 0;
  };
  struct SolveOptions {
    /// Initial guess instead of zero: these basis vectors (the last frame's).
    const std::vector<Vector3>* start = nullptr;
    /// Restricts the solve to these vertices, all others held at zero; for the response to a local
    /// displacement.
    const std::vector<Index>* active_vertices = nullptr;
    /// Relative residual in the preconditioner's norm.
    double tolerance = 1e-14;
    /// Replaces pinned tangents by zero: the response to a displacement instead of to positions.
    bool homogeneous = false;
  };
  /// Solves for the basis vectors. positions: one per vertex. O(edges) per step, at most 30 steps (60 with
  /// metric frames, more where curves are tied).
  Solution solve(std::span<const Vector3> positions, const SolveOptions& options) const;

  /// Tangents, plane normals and energy of a solution.
  Network network(const Solution& solution, std::span<const Vector3> positions) const;
  /// Tangents at both ends of half-edge h: (T(a -> b), T(b -> a)).
  std::pair<Vector3, Vector3> tangents(Index half_edge, std::span<const Vector3> basis) const;

 private:
  enum class PinState : std::uint8_t { none, normal, fixed };

  std::optional<Message> read_tensions(const Polyhedron& polyhedron, const Shaping& shaping);
  std::optional<Message> read_pins(const Polyhedron& polyhedron, const Shaping& shaping);
  std::optional<Message> factor_blocks(const Polyhedron& polyhedron);
  /// Diagonal block of the matrix at the vertex, for one coordinate.
  Eigen::MatrixXd diagonal_block(Index v) const;
  struct Workspace {
    std::vector<Vector3> end_tangents;
    NetworkRays::Workspace rays;
  };
  struct Projected;
  void apply(std::span<const Index> vertices, const std::vector<Vector3>& x, Workspace& work,
             std::vector<Vector3>& y) const;
  void precondition(std::span<const Index> vertices, const std::vector<Vector3>& r,
                    std::vector<Vector3>& z) const;
  /// Removes the components normal to pinned planes.
  void keep_in_planes(std::span<const Index> vertices, std::vector<Vector3>& x) const;
  /// Projects onto the directions that pins leave free: planes, or nothing.
  void project(std::span<const Index> vertices, std::vector<Vector3>& r) const;
  std::vector<Vector3> right_side(std::span<const Index> vertices, std::span<const Vector3> positions) const;
  std::vector<Vector3> starting_point(std::span<const Index> vertices, const SolveOptions& options) const;
  double dot(std::span<const Index> vertices, const std::vector<Vector3>& a,
             const std::vector<Vector3>& b) const;
  /// Computes y = scale y + factor x at these vertices.
  void combine(std::span<const Index> vertices, std::vector<Vector3>& y, double scale, double factor,
               const std::vector<Vector3>& x) const;

  std::shared_ptr<const HalfEdgeMesh> mesh_;
  VertexFrames frames_;
  std::vector<double> beta_, alpha_;
  std::vector<double> edge_weight_;  ///< per edge, 1 in equal frames
  BalancedPulls balanced_;
  CurveTies ties_;
  NetworkRays rays_;  ///< empty in equal frames
  std::vector<Index> all_vertices_;
  /// End 2e: origin of the edge's first half-edge; end 2e + 1: its target.
  std::vector<TangentCoefficients> edge_ends_;
  std::vector<Index> incident_begin_, incident_ends_;  ///< ends at each vertex
  std::vector<std::size_t> block_begin_;
  std::vector<double> block_inverse_;  ///< row-major inverse of each vertex's diagonal block
  bool couples_coordinates_ = false;
  std::vector<PinState> pin_state_;  ///< empty when there are no pins
  std::vector<Vector3> pin_normal_, pinned_basis_;

  /// Conditions of one vertex: per basis vector the projection onto its free directions, and the inverse of
  /// the block restricted to all free directions (three rows per basis vector).
  struct ConditionedVertex {
    std::vector<Matrix3> free;
    std::vector<Vector3> known;  ///< the fixed basis vectors; zero for others
    Eigen::MatrixXd inverse;
  };
  std::map<Index, ConditionedVertex> conditioned_;
  bool plane_conditions_ = false;
};

}  // namespace hariko
