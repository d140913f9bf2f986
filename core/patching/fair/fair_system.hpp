#pragma once

// FairSystem: the linear system of mode FAIR, assembled once per connectivity, tensions and frames, solved
// for any positions (kuriyama.md section 6).

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/fair/boundary_curvature_load.hpp"
#include "core/patching/fair/fair_elements.hpp"
#include "core/patching/fair/fair_numbering.hpp"
#include "core/patching/patch_network.hpp"

namespace hariko {

class FairSweeps;

/// Linear system of mode FAIR. The matrix is kept as dense elements, shared where faces are equal, and
/// applied face by face; it is solved by conjugate gradients, preconditioned by sweeps over the faces.
class FairSystem {
 public:
  /// Assembles the system. `given_side`, per half-edge: the points that serve this border edge are in the
  /// base patch, and its z is zero; empty when there is none. `weights`: instead of `fair_weights`.
  FairSystem(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
             const PatchConstants& constants, const std::vector<bool>& given_side = {},
             const std::optional<FairWeights>& weights = {});
  ~FairSystem();
  FairSystem(const FairSystem&) = delete;
  FairSystem& operator=(const FairSystem&) = delete;

  std::size_t unknown_count() const { return numbering_.count; }
  const HalfEdgeMesh& mesh() const { return *numbering_.mesh; }

  using Field = FairField;

  struct SolveOptions {
    const Field* start = nullptr;  ///< initial guess instead of split points in the middle of faces
    /// Restricts the solve to these faces (ascending); unknowns of other faces and of edges on the rim are
    /// held at zero.
    const std::vector<Index>* active_faces = nullptr;
    /// Borders across which the bending is known; elsewhere it tends to zero.
    std::span<const BoundaryCurvatureLoad> rims = {};
    double tolerance = 1e-13;  ///< relative residual in the preconditioner's norm
    int max_steps = 600;
  };
  struct Solution {
    Field unknowns;
    int iterations = 0;
    bool converged = true;
    bool cancelled = false;
  };

  /// Solves for all unknowns. `base[h]`: control points of patch h with all unknowns zero
  /// (PatchBuilder::base_patch with O and Y zero), for the half-edges of the active faces and of their
  /// neighbours across edges. O(faces) per step.
  Solution solve(std::span<const QuarticPatch> base, const SolveOptions& options,
                 const CancelToken& cancel = {}) const;

  /// Product of the system's matrix with x, per coordinate: for tests and comparisons.
  Field multiply(const Field& x) const;

  /// Extracts split points and their tangents from the unknowns, for the given faces.
  void fill_split_points(const Field& unknowns, std::span<const Index> faces, PatchNetwork& out) const;
  /// Adds the z of the given faces to base patches made with these split points.
  void add_free_parts(const Field& unknowns, std::span<const Index> faces,
                      std::span<QuarticPatch> patches) const;

 private:
  struct Workspace;
  struct Iteration;

  Workspace make_workspace(const SolveOptions& options) const;
  void guess(const Workspace& work, std::span<const QuarticPatch> base, Field& x) const;
  /// Sums the faces' shares of the z unknowns of the active edges, sides of sharp edges included.
  void collect_sides(const Workspace& work, Field& y) const;
  void apply(Workspace& work, const Field& x, Field& y) const;
  void right_side(Workspace& work, std::span<const QuarticPatch> base, Field& b) const;

  FairNumbering numbering_;
  std::vector<double> own_split_;  ///< as in PatchConstants
  std::vector<Vector2> corner_;    ///< per half-edge: its origin in the face's chart
  std::unique_ptr<const FairElements> elements_;
  std::unique_ptr<const FairSweeps> sweeps_;
};

}  // namespace hariko
