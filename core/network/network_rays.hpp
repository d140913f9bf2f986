#pragma once

// NetworkRays: the energy of the split edges (rays) of a network in metric frames, with their split points
// eliminated (kuriyama.md section 12.4).

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/network/balanced_pulls.hpp"
#include "core/network/vertex_frames.hpp"

namespace hariko {

/// Weights of edges and split edges in the energy, by their share of the full turn around their ends and by
/// their length.
struct NetworkWeights {
  std::vector<double> edge;  ///< per edge
  std::vector<double> ray;   ///< per half-edge: the split edge at its origin
};
/// Weights of a network. In equal frames: 1 for every edge, and no rays.
NetworkWeights network_weights(const HalfEdgeMesh& mesh, const VertexFrames& frames);

/// Energy of the split edges as a matrix over the vertices' basis vectors, applied face by face.
class NetworkRays {
 public:
  NetworkRays() = default;
  /// Assembles the rays. `alpha`: vertex tension, per vertex. `weight`: per half-edge, as in
  /// NetworkWeights::ray. The frames must be metric.
  NetworkRays(std::shared_ptr<const HalfEdgeMesh> mesh, const VertexFrames& frames,
              std::span<const double> alpha, std::span<const double> weight, const BalancedPulls& balanced);

  bool empty() const { return rays_.empty(); }

  /// Workspace of a solve.
  struct Workspace {
    std::vector<Index> faces;          ///< faces around the vertices that take part, ascending
    std::vector<Vector3> tangent;      ///< tangent of the split edge at its origin, per half-edge
    std::vector<Matrix3> split_point;  ///< per face: O, Ys and Yc, one per row
  };
  /// Workspace for a solve at these vertices.
  Workspace make_workspace(std::span<const Index> vertices) const;

  /// Adds the matrix's diagonal block of a vertex whose basis begins at `first`.
  void add_diagonal(Index v, Index first, Eigen::MatrixXd& block) const;
  /// Matrix product in three steps: split tangents at the vertices; the split points that minimise the energy
  /// of their faces for these tangents; the contributions of both at the vertices.
  void set_tangents(Index v, const std::vector<Vector3>& x, Workspace& work) const;
  /// for faces of the workspace, by place
  void answer(std::size_t begin, std::size_t end, Workspace& work) const;
  void add_product(Index v, const Workspace& work, std::vector<Vector3>& y) const;
  /// Adds the right-hand side for these positions, one per vertex, at the vertices.
  void add_right_side(std::span<const Index> vertices, std::span<const Vector3> positions,
                      std::vector<Vector3>& b) const;

 private:
  struct Ray {
    /// none where the corner is a half turn: it points to the middle of the face
    TangentCoefficients tangent;
    double weight = 0, alpha = 0;
    double coupling = 1;  ///< coupling to the split point, 0 .. 1 (BalancedPulls)
    Vector3 place;        ///< O + Y is place . (O, Ys, Yc)
    bool known() const { return tangent.basis[0] == no_index; }
  };
  template <class Body>
  void for_rays(Index v, const Body& body) const;

  std::shared_ptr<const HalfEdgeMesh> mesh_;
  std::vector<Ray> rays_;         ///< per half-edge
  std::vector<Matrix3> inverse_;  ///< per face
};

}  // namespace hariko
