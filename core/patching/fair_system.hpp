#pragma once

// FairSystem: the linear system of mode FAIR, assembled once per connectivity, tensions and frames, solved
// for any positions (kuriyama.md section 6).

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/zeroed_array.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/fair_elements.hpp"
#include "core/patching/patch_network.hpp"
#include "core/patching/rim_bend.hpp"

namespace hariko {

/// Unknowns per face: O, Ys, Yc, then z at both ends of each split edge. Per inner smooth edge: z at both
/// ends, shared by its faces. Per side on a sharp edge: z at both ends, the side's own. The matrix is kept as
/// dense elements, shared where faces are equal, and applied face by face; conjugate gradients precondition
/// with the exact inverses of overlapping face blocks.
class FairSystem {
 public:
  /// `given_side`, per half-edge: the points that serve this border edge are in the base patch, their z is
  /// zero; empty when there are none. `weights`: other than `fair_weights`.
  FairSystem(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
             const PatchConstants& constants, const std::vector<bool>& given_side = {},
             const std::optional<FairWeights>& weights = {});

  std::size_t unknown_count() const { return unknown_count_; }
  const HalfEdgeMesh& mesh() const { return *mesh_; }

  /// One vector per unknown.
  using Field = ZeroedArray<Vector3>;

  struct SolveOptions {
    const Field* start = nullptr;  ///< begin here instead of at zero
    /// Solve in these faces (ascending) only; unknowns of other faces and of edges on the rim are held at
    /// zero.
    const std::vector<Index>* active_faces = nullptr;
    std::span<const RimBend> rims =
        {};                    ///< where bending across borders is known; elsewhere it tends to zero
    bool hold_sides = false;   ///< z of the polyhedron's edges stays as in `start`
    double tolerance = 1e-13;  ///< relative residual in the preconditioner's norm
    int max_steps = 600;
  };
  struct Solution {
    Field unknowns;
    int iterations = 0;
    bool converged = true;
    bool cancelled = false;
  };

  /// `base[h]`: control points of patch h with all unknowns zero (PatchBuilder::base_patch with O and Y
  /// zero), for the half-edges of the active faces and of their neighbours across edges. O(faces) a step.
  Solution solve(std::span<const QuarticPatch> base, const SolveOptions& options,
                 const CancelToken& cancel = {}) const;

  /// The force that holds these unknowns: the matrix times them less the right-hand side.
  Field force(std::span<const QuarticPatch> base, const Field& unknowns) const;
  /// Numbers of z at the ends of a half-edge's side, and its factor in the inner points of the half-edge's
  /// patch.
  struct Side {
    std::size_t at_origin, at_target;
    double scale;
  };
  Side side(Index h) const { return {side_origin_[h], side_target_[h], side_scale_[h]}; }

  /// The system's matrix times x, per coordinate: for tests and comparisons.
  Field multiply(const Field& x) const;

  /// Split points and their tangents from the unknowns, for the given faces.
  void fill_split_points(const Field& unknowns, std::span<const Index> faces, PatchNetwork& out) const;
  /// Adds the z of the given faces to base patches that were made with these split points.
  void add_free_parts(const Field& unknowns, std::span<const Index> faces,
                      std::span<QuarticPatch> patches) const;

 private:
  /// Inverse of the matrix restricted to one face's unknowns, weighted for their overlap; shared among equal
  /// faces.
  using Block = Eigen::MatrixXd;
  struct Workspace;
  struct Iteration;

  Workspace make_workspace(const SolveOptions& options) const;
  void number_unknowns();
  void number_sides(const PatchConstants& constants);
  void build_preconditioner(bool shared);
  Block make_block(Index face) const;
  bool is_given(Index h) const { return !given_side_.empty() && given_side_[h]; }
  Eigen::Index local_size(Index face) const { return 3 + 4 * Eigen::Index(mesh_->side_count(face)); }
  /// The face's unknowns in the element's order, z scaled as the element expects (or not, for the
  /// preconditioner).
  void gather(Index face, const Field& x, bool scaled, double* local) const;
  void scatter_interior(Index face, const double* local, Field& y) const;
  /// Adds up the faces' shares of the z unknowns of the active edges, sides of sharp edges included.
  void collect_sides(const Workspace& work, bool scaled, Field& y) const;
  void apply(Workspace& work, const Field& x, Field& y) const;
  void precondition(Workspace& work, const Field& r, Field& z) const;
  void right_side(Workspace& work, std::span<const QuarticPatch> base, Field& b) const;

  std::shared_ptr<const HalfEdgeMesh> mesh_;
  std::size_t unknown_count_ = 0;
  std::size_t first_side_ = 0;            ///< first z of the polyhedron's edges
  std::vector<std::size_t> face_begin_;   ///< first unknown of each face
  std::vector<std::size_t> local_begin_;  ///< place of each face's local vector in workspaces, in unknowns
  std::vector<std::size_t> side_origin_;  ///< per half-edge: unknown z at its origin
  std::vector<std::size_t> side_target_;
  std::vector<double> side_scale_;  ///< per half-edge: factor of the shared z in the own face's point
  std::vector<double> own_split_;   ///< as in PatchConstants
  std::vector<bool> given_side_;
  std::vector<Vector2> corner_;  ///< per half-edge: its origin in the face's chart
  std::shared_ptr<const FairElements> elements_;
  std::vector<std::shared_ptr<const Block>> block_;
};

}  // namespace hariko
