#pragma once

// G2System: the linear system of mode G2, assembled once per connectivity, tags and tensions, solved for any
// positions (g2.md sections 5 and 6).

#include <memory>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/g2/faces/face_region.hpp"
#include "core/g2/g2_given.hpp"

namespace hariko {

/// Linear system of mode G2. Each face is a dense matrix over the unknowns of its corners and sides, with its
/// centre eliminated; equal faces share one. The whole matrix is never stored. It is solved by conjugate
/// gradients, preconditioned with the exact inverses of overlapping blocks, one per face.
class G2System {
 public:
  /// Assembles the system. `ribbons`, per half-edge: prescribed by joins; empty when there are none. With
  /// metric frames, positions matter through the network's frames only.
  G2System(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
           const G2Weights& weights = {}, const std::vector<PrescribedRibbon>& ribbons = {});
  G2System(const G2System&) = delete;
  G2System& operator=(const G2System&) = delete;

  /// Fixes the tangents of the flagged vertices (per vertex; empty: none) to those of the network. Vertices
  /// of joined sides always keep them.
  void fix_tangents(const std::vector<bool>& vertices);

  using References = FaceReferences;
  /// References over a surface whose patch h belongs to half-edge h, with corners centre, origin, target.
  /// They must not outlive the system.
  References over(ReferencePatches patches) const;
  References over(std::shared_ptr<const G2PatchSet> surface) const;
  /// Target curvatures from a reference; for faces with sharp edges from `at_sharp_edges`, if given.
  G2Target target(const References& references, std::span<const Vector3> positions,
                  const References* at_sharp_edges = nullptr) const {
    return curvature_target(layout_, elements_, references, positions, at_sharp_edges);
  }
  /// Measures part of the bending over this surface in faces whose vertices have tension. Does nothing where
  /// there are none.
  void bend_over(const References& references);

  const HalfEdgeMesh& mesh() const { return layout_.mesh(); }
  const std::shared_ptr<const G2Atlas>& atlas() const { return layout_.atlas(); }
  Index unknown_count() const { return layout_.unknowns().count; }
  const FaceChart& chart(Index face) const { return layout_.chart(face); }

  using Given = G2Given;
  /// Resolves the given sides, which must be those that the system was made for.
  GivenSides resolve(std::vector<GivenSide> sides) const {
    return resolve_given_sides(mesh(), layout_.frames(), layout_.unknowns(), std::move(sides));
  }
  using Field = std::vector<Vector3>;  ///< one vector per unknown
  /// Interrupted solution in x alone that ran out of steps and can be continued.
  struct Paused;
  struct SolveOptions {
    const Field* start = nullptr;  ///< initial guess instead of zero
    /// Continues this solution, with its faces and tolerance; needs `only_x`.
    std::shared_ptr<const Paused> paused;
    /// Restricts the solve to these faces (ascending); unknowns shared with other faces are held at zero.
    const std::vector<Index>* active_faces = nullptr;
    bool only_x = false;       ///< positions and network are zero in y and z: a third of the work
    double tolerance = 1e-13;  ///< relative residual in the preconditioner's norm
    int max_steps = 600;
  };
  struct Solution {
    Field unknowns;
    int iterations = 0;
    bool converged = true;
    bool cancelled = false;
    std::shared_ptr<const Paused> paused;  ///< set when an `only_x` solve has not converged
  };
  /// Solves for the unknowns. O(faces) per step.
  Solution solve(const Given& given, const SolveOptions& options, const CancelToken& cancel = {}) const;

  /// Controls of a face (`face_controls`).
  G2Face controls(Index face, const Given& given, const Field& unknowns) const;
  /// Network with the surface's own tangents.
  Network network_of(const Given& given, const Field& unknowns) const;

  /// Bytes of matrices; shared ones are counted once.
  std::size_t matrix_bytes() const;

 private:
  G2System(std::shared_ptr<const HalfEdgeMesh> mesh, const VertexFrames& frames,
           const TensionWeights& weights, double third, const std::vector<PrescribedRibbon>& ribbons);

  template <class Value>
  class Restricted;
  template <class Value>
  Solution solve_in(std::shared_ptr<const FaceRegion> region, const Given& given, const SolveOptions& options,
                    const CancelToken& cancel) const;

  G2Layout layout_;
  FaceElements elements_;
  std::vector<std::shared_ptr<const PaddedMatrix>> blocks_;  ///< per face
  std::vector<bool> joined_;                                 ///< per unknown: given by joins
  std::vector<bool> joined_vertex_;                          ///< per vertex; empty when there are no joins
  std::vector<bool> fixed_;  ///< Per vertex: tangents are the network's; empty when none are.
  std::vector<bool> given_;  ///< per unknown: it has a known value
  std::shared_ptr<const FaceRegion> whole_;
};

}  // namespace hariko
