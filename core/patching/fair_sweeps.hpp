#pragma once

// FairSweeps: the preconditioner of mode FAIR's system, symmetric Gauss-Seidel over overlapping blocks of
// faces (kuriyama.md section 6).

#include <cstdint>
#include <map>
#include <vector>

#include "core/patching/fair_elements.hpp"
#include "core/patching/fair_numbering.hpp"

namespace hariko {

/// One after the other, faces are solved exactly for all their unknowns, z of their sides included; then once
/// more in the opposite order, so that the whole is symmetric. A face that was solved has no residual, and
/// tells its neighbours what it changed in theirs: the residual after the sweeps is known, and with it the
/// matrix times the result. Clusters of one colour have no common neighbour and are solved side by side:
/// results do not depend on the number of threads.
class FairSweeps {
 public:
  /// `shared`: equal faces with equal neighbours have one block. Both are kept by reference.
  FairSweeps(const FairElements& elements, const FairNumbering& numbering, bool shared);

  /// Inverse of the matrix restricted to one face's unknowns.
  using Block = Eigen::MatrixXd;

  /// Sweeps over some of the faces; unknowns of others, and z of the sides between, are held at zero.
  struct Plan {
    std::vector<Index> faces;                              ///< ascending
    std::vector<bool> active;                              ///< per face
    std::vector<std::vector<std::vector<Index>>> colours;  ///< clusters by their colour
    std::map<Index, Block> rim;                            ///< blocks of faces with held sides
    /// Local vectors; the residual of z is that of the element's.
    ZeroedArray<double> residual, correction;
  };
  Plan plan(std::vector<Index> faces) const;

  /// z = M r and image = A z, for the unknowns of the plan's faces and the sides that they share.
  void apply(Plan& plan, const FairField& r, FairField& z, FairField& image) const;

 private:
  void find_clusters();
  void find_colours();
  /// Calls body with every face on the other side of a smooth edge.
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
  std::vector<double> entries_;           ///< of all blocks, cluster by cluster
  std::vector<std::size_t> block_begin_;  ///< per face
};

}  // namespace hariko
