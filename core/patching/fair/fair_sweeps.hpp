#pragma once

// FairSweeps: the preconditioner of mode FAIR's system, symmetric Gauss-Seidel over overlapping blocks of
// faces (kuriyama.md section 6).

#include <cstdint>
#include <map>
#include <vector>

#include "core/patching/fair/fair_elements.hpp"
#include "core/patching/fair/fair_numbering.hpp"

namespace hariko {

/// Symmetric Gauss-Seidel preconditioner. Faces are solved exactly, one after the other, for all their
/// unknowns, z of their sides included; then once more in the opposite order, so that the whole is symmetric.
/// A solved face has no residual, and the effect of its change is subtracted from its neighbours' residuals:
/// so the residual after the sweeps is known, and with it the product of the matrix with the result. Clusters
/// of one colour have no common neighbour and are solved in parallel: results do not depend on the number of
/// threads.
class FairSweeps {
 public:
  /// Computes the blocks. `shared`: equal faces with equal neighbours share a block. `elements` and
  /// `numbering` are kept by reference.
  FairSweeps(const FairElements& elements, const FairNumbering& numbering, bool shared);

  /// Inverse of the matrix restricted to one face's unknowns.
  using Block = Eigen::MatrixXd;

  /// Sweeps over some of the faces; the unknowns of other faces, and z of the sides between, are held at
  /// zero.
  struct Plan {
    std::vector<Index> faces;                              ///< ascending
    std::vector<bool> active;                              ///< per face
    std::vector<std::vector<std::vector<Index>>> colours;  ///< active faces of each cluster, by colour
    std::map<Index, Block> rim;                            ///< blocks of faces with held sides
    /// Local vectors; the residual of z is scaled as in the element.
    ZeroedArray<double> residual, correction;
  };
  /// Plan for sweeps over some faces, ascending.
  Plan plan(std::vector<Index> faces) const;

  /// Applies the preconditioner: z = M r and image = A z, for the unknowns of the plan's faces and the sides
  /// that they share.
  void apply(Plan& plan, const FairField& r, FairField& z, FairField& image) const;

 private:
  void find_clusters();
  void find_colours();
  /// Calls body for every face across a smooth edge.
  template <class Body>
  void for_neighbours(Index face, const Body& body) const {
    for (Index h = mesh_.face_begin(face); h < mesh_.face_end(face); ++h)
      if (elements_.edge(mesh_.edge(h))) body(mesh_.face(mesh_.twin(h)));
  }
  void make_blocks(bool shared);
  std::vector<std::uintptr_t> surroundings(Index face) const;
  Block make_block(Index face) const;
  void add_neighbours(Index face, const Eigen::VectorXd& scale, Eigen::MatrixXd& matrix) const;
  Block without_held_sides(Index face, const std::vector<bool>& active) const;
  bool joins(const Plan& plan, Index h) const;
  void begin(Plan& plan, Index face, const FairField& r) const;
  void solve_face(Plan& plan, Index face, std::vector<double>& change) const;
  void fetch(const Plan& plan, Index face) const;
  void tell_neighbour(Plan& plan, Index h, const double* change) const;
  void finish(const Plan& plan, Index face, const FairField& r, FairField& z, FairField& image) const;

  const FairElements& elements_;
  const FairNumbering& numbering_;
  const HalfEdgeMesh& mesh_;
  std::vector<std::vector<Index>> clusters_;
  std::vector<std::size_t> colour_;  ///< per cluster
  std::size_t colour_count_ = 0;
  std::vector<double> entries_;           ///< entries of all blocks, cluster by cluster
  std::vector<std::size_t> block_begin_;  ///< per face
};

}  // namespace hariko
