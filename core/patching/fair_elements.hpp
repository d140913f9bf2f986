#pragma once

// Finite elements of mode FAIR: quadratic fairness energy of patches and of curvature jumps over edges, as
// small dense matrices that depend on connectivity and tensions only (kuriyama.md section 6).

#include <map>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/patching/patch_constants.hpp"
#include "core/patching/quartic_basis.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

/// Weights of the energy (kuriyama.md section 6).
struct FairWeights {
  double curvature_jump = 10;  ///< mu
  double pair_distance = 10;   ///< lambda
  double tension = 2;          ///< kappa: membrane energy per unit of excess tension
};

using ControlMatrix = Eigen::Matrix<double, quartic_control_count, quartic_control_count>;
/// Rows: the 6 Gauss points of an edge; columns: control points of one patch.
using JumpRows = Eigen::Matrix<double, 6, quartic_control_count>;

/// Unknowns that a patch depends on: O, Ys, Yc, then z at O and at the vertex of its first and of its second
/// split edge, then z at both ends of its side.
inline constexpr int patch_unknown_count = 9;
using PatchMatrix = Eigen::Matrix<double, quartic_control_count, patch_unknown_count>;
using JumpColumns = Eigen::Matrix<double, 6, patch_unknown_count>;

/// Thin-plate energy K_n and membrane energy M_n of a patch in a regular n-gon of unit side.
struct PatchEnergy {
  ControlMatrix plate, membrane;
};
PatchEnergy patch_energy(Index sides);

/// The face's element. Unknowns of an n-sided face: O, Ys, Yc, then (z at O, z at vertex) per split edge,
/// then (z at origin, z at target) per side: 3 + 4n.
struct FaceElement {
  Index sides = 0;
  Eigen::MatrixXd matrix;
  ControlMatrix energy;                 ///< K + tau M + lambda pairs, of one patch
  std::vector<PatchMatrix> dependence;  ///< per side: control points from the patch's unknowns
  std::vector<JumpRows> split_left,
      split_right;  ///< per split edge: weighted jump rows of patch j and patch j - 1

  /// Place of patch j's unknowns in the face's.
  std::array<int, patch_unknown_count> columns(Index side) const;
};

/// The element of an inner smooth edge: weighted jump rows of the patches on both sides.
struct EdgeElement {
  JumpRows first_rows, second_rows;
  JumpColumns first_columns, second_columns;
};

/// Elements by what they depend on; equal faces share one. Not thread-safe.
class FairElements {
 public:
  explicit FairElements(const FairWeights& weights) : weights_(weights) {}

  /// `free_corner[j]`: the corner's split tangent is free. `tau`: membrane weight of the face.
  const FaceElement* face(Index sides, const std::vector<bool>& free_corner, double tau);
  /// Edge between side `first_side` of a face with element `first`, and side `second_side` of `second`.
  const EdgeElement* edge(const FaceElement* first, Index first_side, const FaceElement* second,
                          Index second_side, double c_start, double c_end);
  std::size_t face_element_count() const { return faces_.size(); }
  std::size_t edge_element_count() const { return edges_.size(); }

 private:
  FairWeights weights_;
  std::map<Index, PatchEnergy> energies_;
  std::map<std::vector<double>, std::unique_ptr<FaceElement>> faces_;
  std::map<std::vector<double>, std::unique_ptr<EdgeElement>> edges_;
};

}  // namespace hariko
