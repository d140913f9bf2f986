#pragma once

// CurveTies: ties between curves of a network in metric frames that run close to each other (kuriyama.md
// section 12.8).

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/network/vertex_frames.hpp"

namespace hariko {

struct NetworkWeights;

/// Energies that keep curves apart where the polyhedron is far narrower than the curves are long. The two
/// sides of a face next to a far shorter side bulge alike, and a side does not bulge past a corner of its
/// face that is close to it. Computed for fixed frames; linear in the positions. Cages with edges of similar
/// lengths have no ties.
class CurveTies {
 public:
  /// Ties nothing.
  CurveTies() = default;
  /// Finds the ties. `beta`: edge tension, per edge. The frames must be metric. O(edges), plus the square of
  /// the number of sides of each face.
  CurveTies(const HalfEdgeMesh& mesh, const VertexFrames& frames, const NetworkWeights& weights,
            std::span<const double> beta, std::span<const Vector3> positions);

  bool empty() const { return ties_.empty(); }

  /// Adds the ties' part of the matrix's diagonal block of a vertex whose basis begins at `first`.
  void add_diagonal(Index v, Index first, Eigen::MatrixXd& block) const;
  /// Adds the vertex's part of the ties' product with x.
  void add_product(Index v, const std::vector<Vector3>& x, std::vector<Vector3>& y) const;
  /// Adds the ties' right-hand side for these positions at the vertices.
  void add_right_side(std::span<const Index> vertices, std::span<const Vector3> positions,
                      std::vector<Vector3>& b) const;

 private:
  /// Energy of a tie: half the weight times the square of first + second - goal, with images of basis vectors
  /// at two vertices.
  struct Tie {
    std::array<TangentCoefficients, 2> end;
    double weight;
    /// Goal: the sum of these positions times the factors.
    std::array<Index, 4> vertex;
    std::array<double, 4> factor;
  };
  /// Reference to a tie from one of its vertices.
  struct Seen {
    std::size_t tie;
    std::size_t own;  ///< the tie's end at the vertex
  };

  void add(const Tie& tie, Index first, Index second);
  void tie_beside_short_sides(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                              std::span<const double> pull);
  void tie_to_close_corners(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                            std::span<const double> pull, std::span<const Vector3> positions);

  std::vector<Tie> ties_;
  std::vector<std::vector<Seen>> seen_;  ///< per vertex; empty where nothing is tied
};

}  // namespace hariko
