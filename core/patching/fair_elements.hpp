#pragma once

// Finite elements of mode FAIR: quadratic fairness energy of patches and of curvature jumps over edges, as
// small dense matrices (kuriyama.md sections 6 and 12.5).

#include <array>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/gauss.hpp"
#include "core/patching/fair_measures.hpp"
#include "core/patching/quartic_basis.hpp"
#include "core/polyhedron/half_edge_mesh.hpp"

namespace hariko {

using ControlMatrix = Eigen::Matrix<double, quartic_control_count, quartic_control_count>;
/// Rows: the 6 Gauss points of an edge; columns: control points of one patch.
using JumpRows = Eigen::Matrix<double, 6, quartic_control_count>;

/// Unknowns that a patch depends on: O, Ys, Yc, then z at O and at the vertex of its first and of its second
/// split edge, then z at both ends of its side.
inline constexpr int patch_unknown_count = 9;
using PatchMatrix = Eigen::Matrix<double, quartic_control_count, patch_unknown_count>;
using JumpColumns = Eigen::Matrix<double, 6, patch_unknown_count>;

/// Thin-plate energy and membrane energy of a patch over a triangle.
struct PatchEnergy {
  ControlMatrix plate, membrane;
};
/// Over the triangle of a regular n-gon of unit side.
PatchEnergy patch_energy(Index sides);

/// Integrals from which the energies over all triangles, and the jumps over all edges, are combined.
class FairTables {
 public:
  FairTables();
  /// plate K + membrane M over the triangle.
  ControlMatrix energy(const ChartTriangle& triangle, double plate, double membrane) const;

  /// The sides of a patch, each from one of its ends.
  enum Side { centre_to_first, centre_to_second, first_to_second, second_to_first };
  /// Second derivative of the patch along the topological transversal of a side, at its Gauss points, times
  /// the root of the weight (kuriyama.md section 6, J(t)). `amount`: of the patch in the side's condition.
  JumpRows jump_rows(Side side, double c_start, double c_end, double amount, double weight) const;

 private:
  /// Integrals over the standard triangle of the products of second derivatives along v v, v w, w w (1-1,
  /// 1-2, 1-3, 2-2, 2-3, 3-3), and of first derivatives along v, w.
  std::array<ControlMatrix, 6> second_;
  std::array<ControlMatrix, 3> first_;
  /// Per side and Gauss point: second derivatives of the functions by (start, end, third): 00 11 22 01 02 12.
  using PointTable = std::array<std::array<double, quartic_control_count>, 6>;
  std::array<std::array<PointTable, 6>, 4> sides_;
  std::vector<GaussPoint> points_;
};

/// One patch's matrices.
struct PatchParts {
  ControlMatrix energy;    ///< of its own
  PatchMatrix dependence;  ///< control points from the patch's unknowns
  JumpRows first, second;  ///< weighted jump rows at its first and its second split edge
};
/// `following`: of the next patch of the face.
PatchParts patch_parts(const FairTables& tables, const PatchMeasure& patch, const PatchMeasure& following);

/// The face's element. Unknowns of an n-sided face: O, Ys, Yc, then (z at O, z at vertex) per split edge,
/// then (z at origin, z at target) per side: 3 + 4n.
struct FaceElement {
  Index sides = 0;
  Eigen::MatrixXd matrix;
  std::vector<PatchParts> parts;  ///< per side; none where no other face shares the element

  /// Place of patch j's unknowns in the face's.
  std::array<int, patch_unknown_count> columns(Index side) const;
};

/// Jump rows of the patches on both sides of an inner smooth edge.
struct EdgeRows {
  JumpRows first, second;
};
EdgeRows edge_rows(const FairTables& tables, const EdgeMeasure& edge);

/// The element of an inner smooth edge.
struct EdgeElement {
  JumpColumns first_columns, second_columns;
  std::unique_ptr<EdgeRows> rows;  ///< none where no other edge shares the element
};

/// Elements by what they depend on. With `shared`, equal faces and edges have one; else each its own. Not
/// thread-safe, but for faces and edges whose elements are their own.
class FairElements {
 public:
  FairElements(const FairMeasures& measures, const HalfEdgeMesh& mesh, bool shared);

  const FaceElement* face(Index face) const { return faces_[face].get(); }
  const EdgeElement* edge(Index edge) const { return edges_[edge].get(); }  ///< null on sharp edges
  /// Matrices of a face's patches: those of its element, or made in `room`.
  std::span<const PatchParts> parts(Index face, std::vector<PatchParts>& room) const;
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
