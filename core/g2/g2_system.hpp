#pragma once

// G2System: the linear system of mode G2, assembled once per connectivity, tags and tensions, solved for any
// positions (g2.md sections 5 and 6).

#include <memory>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/g2/face_region.hpp"
#include "core/g2/g2_given.hpp"

namespace hariko {

/// Every face is a dense matrix over the unknowns of its corners and sides, with its centre eliminated; equal
/// faces share one. The matrix of the whole is never stored. Conjugate gradients precondition with the exact
/// inverses of overlapping blocks, one a face.
class G2System {
 public:
  /// `ribbons`, per half-edge: what joins give; empty when there are none. Frames by measure: positions
  /// matter through the network's frames only.
  G2System(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
           const G2Weights& weights = {}, const std::vector<GivenRibbon>& ribbons = {});
  G2System(const G2System&) = delete;
  G2System& operator=(const G2System&) = delete;

  /// Flags, per vertex: those that keep the network's tangents as they are. Empty: none. Vertices of joined
  /// sides always do.
  void fix_tangents(const std::vector<bool>& vertices);

  using References = FaceReferences;
  /// Patch h belongs to half-edge h, corners: centre, origin, target. Not to outlive the system.
  References over(ReferencePatches patches) const;
  References over(std::shared_ptr<const G2PatchSet> surface) const;
  G2Target target(const References& references, std::span<const Vector3> positions,
                  const References* at_sharp_edges = nullptr) const {
    return curvature_target(layout_, elements_, references, positions, at_sharp_edges);
  }
  /// Faces with a tension of vertices measure part of their bending over this surface. Does nothing where
  /// there are none.
  void bend_over(const References& references);

  const HalfEdgeMesh& mesh() const { return layout_.mesh(); }
  const std::shared_ptr<const G2Atlas>& atlas() const { return layout_.atlas(); }
  Index unknown_count() const { return layout_.unknowns().count; }
  const FaceChart& chart(Index face) const { return layout_.chart(face); }

  using Given = G2Given;
  /// The sides must be those that the system was made for.
  GivenSides resolve(std::vector<GivenSide> sides) const {
    return resolve_given_sides(mesh(), layout_.frames(), layout_.unknowns(), std::move(sides));
  }
  using Field = std::vector<Vector3>;  ///< one vector per unknown
  /// A solution in x alone that ran out of steps, to be gone on with.
  struct Paused;
  struct SolveOptions {
    const Field* start = nullptr;  ///< begin here instead of at zero
    /// Go on here, with the faces and the tolerance of that solution; `only_x`.
    std::shared_ptr<const Paused> paused;
    /// Solve in these faces (ascending) only; unknowns that other faces share are held at zero.
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
    std::shared_ptr<const Paused> paused;  ///< with `only_x`, where it has not converged
  };
  Solution solve(const Given& given, const SolveOptions& options, const CancelToken& cancel = {}) const;

  /// All controls of a face (`face_controls`).
  G2Face controls(Index face, const Given& given, const Field& unknowns) const;
  /// The network with the tangents that the surface has.
  Network network_of(const Given& given, const Field& unknowns) const;

  std::size_t element_count() const { return elements_.count(); }
  /// Bytes of matrices, shared ones counted once.
  std::size_t matrix_bytes() const;

 private:
  G2System(std::shared_ptr<const HalfEdgeMesh> mesh, const VertexFrames& frames,
           const TensionWeights& weights, double third, const std::vector<GivenRibbon>& ribbons);

  template <class Value>
  class Restricted;
  template <class Value>
  Solution solve_in(std::shared_ptr<const FaceRegion> region, const Given& given, const SolveOptions& options,
                    const CancelToken& cancel) const;

  G2Layout layout_;
  FaceElements elements_;
  std::vector<std::shared_ptr<const PaddedMatrix>> blocks_;  ///< per face
  std::vector<bool> joined_;                                 ///< per unknown: joins give it
  std::vector<bool> joined_vertex_;                          ///< per vertex; empty when there are no joins
  std::vector<bool> fixed_;  ///< per vertex: tangents are the network's; empty when none are
  std::vector<bool> given_;  ///< per unknown: it has a value already
  std::shared_ptr<const FaceRegion> whole_;
};

}  // namespace hariko
