#pragma once

// NetworkRays: the split edges' part in the energy of a network by measure, with their split points
// eliminated (kuriyama.md section 12.4).

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/network/balanced_pulls.hpp"
#include "core/network/vertex_frames.hpp"

namespace hariko {

/// How much edges and split edges count, by the part of the turn round their ends that is theirs and by their
/// length.
struct NetworkWeights {
  std::vector<double> edge;  ///< per edge
  std::vector<double> ray;   ///< per half-edge: the split edge at its origin
};
/// All 1, and no rays, in equal frames.
NetworkWeights network_weights(const HalfEdgeMesh& mesh, const VertexFrames& frames);

class NetworkRays {
 public:
  NetworkRays() = default;
  /// `alpha`: per vertex. The frames must be by measure.
  NetworkRays(std::shared_ptr<const HalfEdgeMesh> mesh, const VertexFrames& frames,
              std::span<const double> alpha, std::span<const double> weight, const BalancedPulls& balanced);

  bool empty() const { return rays_.empty(); }

  /// Room for a solve.
  struct Workspace {
    std::vector<Index> faces;          ///< round the vertices that take part, ascending
    std::vector<Vector3> tangent;      ///< per half-edge: of the split edge at its origin
    std::vector<Matrix3> split_point;  ///< per face: a row each for O, Ys and Yc
  };
  Workspace make_workspace(std::span<const Index> vertices) const;

  /// Adds the matrix's diagonal block of a vertex whose basis begins at `first`.
  void add_diagonal(Index v, Index first, Eigen::MatrixXd& block) const;
  /// The matrix's product is made in three steps: split tangents at the vertices, the faces' answer, and what
  /// both add at the vertices.
  void set_tangents(Index v, const std::vector<Vector3>& x, Workspace& work) const;
  void answer(std::size_t begin, std::size_t end, Workspace& work) const;  ///< faces of the workspace
  void add_product(Index v, const Workspace& work, std::vector<Vector3>& y) const;
  /// Adds the right-hand side that these positions, one a vertex, give at the vertices.
  void add_right_side(std::span<const Index> vertices, std::span<const Vector3> positions,
                      std::vector<Vector3>& b) const;

 private:
  struct Ray {
    TangentCoefficients tangent;  ///< none where the corner is a half turn: it points to the face's middle
    double weight = 0, alpha = 0;
    double coupling = 1;  ///< to the split point, 0 .. 1 (BalancedPulls)
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
