#pragma once

// SubdivisionTopology: data of a Catmull-Clark surface that depend on the connectivity of its mesh alone:
// patches, their seams, and the weights of control points at parameters, which OpenSubdiv computes. Made
// once, shared by all positions.

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/subdivision/control_mesh.hpp"
#include "core/subdivision/stencil_kernel.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// The patches are the faces where all are quads. Otherwise every face is divided at its centre and the
/// midpoints of its edges, a quad into four patches, a triangle into three, so that the sides of neighbours
/// are the same curves. Corner 0 of a divided patch is the face's corner, corner 2 its centre.
class SubdivisionTopology {
 public:
  /// Subdivision level below the control mesh at which the approximation near extraordinary vertices begins.
  static constexpr int isolation = 9;

  /// Makes the topology. Errors: those of `check`; E_CONTROL_MESH where OpenSubdiv refuses the mesh.
  static Result<std::shared_ptr<const SubdivisionTopology>> make(const ControlMesh& mesh);
  ~SubdivisionTopology();
  SubdivisionTopology(const SubdivisionTopology&) = delete;
  SubdivisionTopology& operator=(const SubdivisionTopology&) = delete;

  /// Mesh that it was made from; its positions are meaningless.
  const ControlMesh& mesh() const { return mesh_; }
  bool cut() const { return cut_; }

  Index patch_count() const { return Index(patches_.size()); }
  Index face_of(Index patch) const { return patches_[patch].face; }
  /// Corner of the face at which the patch lies; 0 for whole faces.
  int corner_of(Index patch) const { return patches_[patch].corner; }
  /// Control points that the patch depends on.
  std::span<const Index> controls(Index patch) const;

  /// Weights at a parameter: rows of controls(patch).size() numbers for the position, the derivatives by s
  /// and t and those of second order. The position of a point on a side is that of the side's owner: see
  /// `owner`.
  struct Weights {
    std::vector<double> value, ds, dt, dss, dst, dtt;
  };
  Weights weights(Index patch, const Vector2& parameter, Order order) const;
  enum class Derivatives { first, second };
  std::shared_ptr<const StencilTable> table(Index patch, int density, Derivatives which) const;

  /// Patch side whose curve a side uses, and whether it runs in the opposite direction there.
  struct Owner {
    PatchSide side;
    bool reversed = false;
  };
  const Owner& owner(PatchSide side) const { return owners_[4 * side.patch + side.side]; }
  /// Patch and corner that determine the position of a node.
  struct NodeOwner {
    Index patch;
    int corner;
  };
  const NodeOwner& node_owner(Index node) const { return node_owners_[node]; }
  Index node(Index patch, int corner) const { return (*corner_nodes_)[4 * patch + Index(corner)]; }
  Index node_count() const { return Index(node_owners_.size()); }
  /// Control vertex of a node; no_index for midpoints of edges and faces.
  Index node_vertex(Index node) const { return node_vertices_[node]; }
  /// Node of a control vertex; no_index where no face uses it.
  Index vertex_node(Index vertex) const { return vertex_nodes_[vertex]; }
  /// Patch sides that make up the edge from control vertex a to b, in order: one, or two when faces are
  /// divided. Empty when no face has the edge a -> b.
  std::vector<PatchSide> edge_sides(Index a, Index b) const;

  CornerSecondOrder second_order(Index patch, int corner) const {
    return CornerSecondOrder(second_order_[4 * patch + Index(corner)]);
  }
  /// Whether the patch is one bicubic polynomial.
  bool polynomial(Index patch) const { return classes_[patches_[patch].shape].polynomial; }

  /// Tables that surfaces share.
  const std::shared_ptr<const std::vector<Seam>>& seams() const { return seams_; }
  const std::shared_ptr<const std::vector<Index>>& corner_nodes() const { return corner_nodes_; }
  const std::shared_ptr<const std::vector<PatchSide>>& boundary_sides() const { return boundary_sides_; }
  const std::shared_ptr<const std::vector<Element>>& boundary_sources() const { return boundary_sources_; }
  const std::shared_ptr<const std::vector<Provenance>>& provenance() const { return provenance_; }

 private:
  struct Evaluator;  // data of OpenSubdiv
  struct Patch {
    Index face;
    int corner;
    Index shape = 0;
  };
  /// Class of patches with the same weights, which share tables.
  struct Shape {
    Index patch;
    bool polynomial = false;
  };
  explicit SubdivisionTopology(ControlMesh mesh);
  void add_patches();
  void number_nodes();
  void join_sides();
  void classify_vertices();
  void find_shapes();
  bool is_polynomial(Index patch) const;
  Vector2 face_parameter(const Patch& patch, const Vector2& parameter) const;

  ControlMesh mesh_;
  bool cut_ = false;
  std::unique_ptr<Evaluator> evaluator_;
  std::vector<Patch> patches_;
  std::vector<Index> first_patch_;  ///< first patch of each face
  std::vector<Shape> classes_;
  std::vector<Owner> owners_;
  std::vector<NodeOwner> node_owners_;
  std::vector<Index> node_vertices_, vertex_nodes_;
  std::vector<CornerSecondOrder> second_order_;
  std::map<std::pair<Index, Index>, std::pair<Index, int>> half_edges_;  ///< (a, b) -> face, side number
  std::shared_ptr<const std::vector<Seam>> seams_;
  std::shared_ptr<const std::vector<Index>> corner_nodes_;
  std::shared_ptr<const std::vector<PatchSide>> boundary_sides_;
  std::shared_ptr<const std::vector<Element>> boundary_sources_;
  std::shared_ptr<const std::vector<Provenance>> provenance_;

  mutable std::mutex mutex_;
  mutable std::map<std::tuple<Index, int, Derivatives>, std::shared_ptr<const StencilTable>> tables_;
  mutable std::size_t table_bytes_ = 0;
};

}  // namespace hariko
