#pragma once

// CurveTies: curves of a network by measure that run close to each other (kuriyama.md section 12.8).

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/network/vertex_frames.hpp"

namespace hariko {

struct NetworkWeights;

/// Energies that keep curves apart where the polyhedron is far narrower than they are long. Both sides of a
/// face next to a far shorter one bulge alike, and a side does not bulge past a corner of its face that is
/// close to it. Values for frozen frames; linear in the positions. Nothing is tied in even cages.
class CurveTies {
 public:
  /// Nothing is tied.
  CurveTies() = default;
  /// `beta`: per edge. The frames must be by measure. O(edges), and the square of a face's sides.
  CurveTies(const HalfEdgeMesh& mesh, const VertexFrames& frames, const NetworkWeights& weights,
            std::span<const double> beta, std::span<const Vector3> positions);

  bool empty() const { return ties_.empty(); }

  /// Adds the matrix's diagonal block of a vertex whose basis begins at `first`.
  void add_diagonal(Index v, Index first, Eigen::MatrixXd& block) const;
  /// Adds the vertex's part of the matrix's product with x.
  void add_product(Index v, const std::vector<Vector3>& x, std::vector<Vector3>& y) const;
  /// Adds the right-hand side that these positions give at the vertices.
  void add_right_side(std::span<const Index> vertices, std::span<const Vector3> positions,
                      std::vector<Vector3>& b) const;

 private:
  /// Half the weight times the square of first + second - goal, images of basis vectors at two vertices.
  struct Tie {
    std::array<TangentCoefficients, 2> end;
    double weight;
    /// The goal: the sum of these positions times the factors.
    std::array<Index, 4> vertex;
    std::array<double, 4> factor;
  };
  /// A tie as one of its vertices sees it.
  struct Seen {
    std::size_t tie;
    std::size_t own;  ///< end of the tie
  };

  void add(const Tie& tie, Index first, Index second);
  void tie_beside_short_sides(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                              std::span<const double> pull);
  void tie_to_close_corners(const HalfEdgeMesh& mesh, const VertexFrames& frames,
                            std::span<const double> pull, std::span<const Vector3> positions);

  std::vector<Tie> ties_;
  std::vector<std::vector<Seen>> seen_;  ///< per vertex; none where nothing is tied
};

}  // namespace hariko
