#pragma once

// Finite elements of mode FAIR: quadratic fairness energy of patches and of curvature jumps across edges, as
// small dense matrices (kuriyama.md sections 6 and 12.5).

#include <array>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/gauss_legendre.hpp"
#include "core/patching/fair/fair_measures.hpp"
#include "core/patching/quartic/quartic_basis.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

using ControlMatrix = Eigen::Matrix<double, quartic_control_count, quartic_control_count>;
/// Jumps across an edge: rows are its 6 Gauss points, columns the control points of one patch.
using JumpRows = Eigen::Matrix<double, 6, quartic_control_count>;

/// Number of unknowns of a patch: O, Ys, Yc, then z at O and at the vertex of its first and of its second
/// split edge, then z at both ends of its side.
inline constexpr int patch_unknown_count = 9;
using PatchMatrix = Eigen::Matrix<double, quartic_control_count, patch_unknown_count>;
using JumpColumns = Eigen::Matrix<double, 6, patch_unknown_count>;

/// Thin-plate energy and membrane energy of a patch over a triangle.
struct PatchEnergy {
  ControlMatrix plate, membrane;
};
/// Energies over the triangle of a regular n-gon with unit side.
PatchEnergy patch_energy(Index sides);

/// Tables of integrals from which the energies over all triangles, and the jumps across all edges, are
/// combined.
class FairTables {
 public:
  /// Computes the integrals, by Gauss quadrature.
  FairTables();
  /// Energy matrix plate K + membrane M over a triangle.
  ControlMatrix energy(const ChartTriangle& triangle, double plate, double membrane) const;

  /// Sides of a patch, each from one of its ends.
  enum Side { centre_to_first, centre_to_second, first_to_second, second_to_first };
  /// Second derivative of the patch along the topological transversal of a side, at its Gauss points, times
  /// the root of the weight (kuriyama.md section 6, J(t)). `amount`: weight of the patch's point in the
  /// side's condition.
  JumpRows jump_rows(Side side, double c_start, double c_end, double amount, double weight) const;

 private:
  /// Integrals over the standard triangle of the products of second derivatives along v v, v w, w w (1-1,
  /// 1-2, 1-3, 2-2, 2-3, 3-3), and of first derivatives along v, w.
  std::array<ControlMatrix, 6> second_;
  std::array<ControlMatrix, 3> first_;
  /// Second derivatives of the basis functions per side and Gauss point, by (start, end, third): 00 11 22 01
  /// 02 12.
  using PointTable = std::array<std::array<double, quartic_control_count>, 6>;
  std::array<std::array<PointTable, 6>, 4> sides_;
  std::vector<GaussPoint> points_;
};

/// Matrices of one patch.
struct PatchParts {
  ControlMatrix energy;    ///< energy of the patch alone
  PatchMatrix dependence;  ///< control points as functions of the patch's unknowns
  JumpRows first, second;  ///< weighted jump rows at its first and its second split edge
};
/// Matrices of a patch. `following`: measures of the next patch of the face.
PatchParts patch_parts(const FairTables& tables, const PatchMeasure& patch, const PatchMeasure& following);

/// Element of a face. Unknowns of an n-sided face: O, Ys, Yc, then (z at O, z at vertex) per split edge, then
/// (z at origin, z at target) per side: 3 + 4n.
struct FaceElement {
  Index sides = 0;
  Eigen::MatrixXd matrix;
  std::vector<PatchParts> parts;  ///< per side; empty where no other face shares the element

  /// Places of patch j's unknowns among the face's.
  std::array<int, patch_unknown_count> columns(Index side) const;
};

/// Jump rows of the patches on both sides of an inner smooth edge.
struct EdgeRows {
  JumpRows first, second;
};
/// Jump rows of an inner smooth edge.
EdgeRows edge_rows(const FairTables& tables, const EdgeMeasure& edge);

/// Element of an inner smooth edge.
struct EdgeElement {
  JumpColumns first_columns, second_columns;
  std::unique_ptr<EdgeRows> rows;  ///< null where no other edge shares the element
};

/// Elements of all faces and edges. With `shared`, equal faces and edges have a common element; otherwise
/// each has its own. Not thread-safe, except for faces and edges that have their own elements.
class FairElements {
 public:
  FairElements(const FairMeasures& measures, const HalfEdgeMesh& mesh, bool shared);

  const FaceElement* face(Index face) const { return faces_[face].get(); }
  const EdgeElement* edge(Index edge) const { return edges_[edge].get(); }  ///< null on sharp edges
  /// Matrices of a face's patches: those stored in its element, or computed into `room`.
  std::span<const PatchParts> parts(Index face, std::vector<PatchParts>& room) const;
  /// Jump rows of an edge: those stored in its element, or computed into `room`.
  const EdgeRows& rows(Index edge, EdgeRows& room) const;

 private:
  std::shared_ptr<FaceElement> make_face(Index face) const;
  std::shared_ptr<EdgeElement> make_edge(Index edge) const;
  std::vector<double> key_of_face(Index face) const;
  void share();

  const HalfEdgeMesh& mesh_;
  FairTables tables_;
  FairMeasures measures_;
  bool shared_;
  std::vector<std::shared_ptr<const FaceElement>> faces_;
  std::vector<std::shared_ptr<const EdgeElement>> edges_;
};

}  // namespace hariko
