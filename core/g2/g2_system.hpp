#pragma once

// G2System: the linear system of mode G2, assembled once per connectivity, tags and tensions, solved for any
// positions (g2.md sections 5 and 6).

#include <memory>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/g2/face_energy.hpp"
#include "core/g2/face_reference.hpp"
#include "core/g2/g2_patch_set.hpp"
#include "core/g2/given_sides.hpp"
#include "core/g2/unknowns.hpp"
#include "core/network/network_system.hpp"

namespace hariko {

/// Contribution of a face's target to the right-hand side, and to its centre's coefficients; in the order of
/// the chart's places.
struct FaceTarget {
  std::vector<Vector3> load, centre;
};
using G2Target = std::vector<FaceTarget>;  ///< per face

/// Every face is a dense matrix over the unknowns of its corners and sides, with its centre eliminated; equal
/// faces share one. The matrix of the whole is never stored. Conjugate gradients precondition with the exact
/// inverses of overlapping blocks, one a face.
class G2System {
 public:
  /// `ribbons`, per half-edge: what joins give; empty when there are none. Frames by measure: positions
  /// matter through the network's frames only.
  G2System(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
           const G2Weights& weights = {}, const std::vector<GivenRibbon>& ribbons = {});
  ~G2System();

  /// Flags, per vertex: those that keep the network's tangents as they are. Empty: none. Vertices of joined
  /// sides always do.
  void fix_tangents(const std::vector<bool>& vertices);

  using References = std::function<FaceReference(Index face, const ChartSamples& samples)>;
  /// Patch h belongs to half-edge h, corners: centre, origin, target.
  References over(ReferencePatches patches) const;
  References over(std::shared_ptr<const G2PatchSet> surface) const;
  /// Curvature to come near to, from a reference; at faces with a border or a crease from `at_sharp_edges`,
  /// if it is given. For the elements as they are. O(faces).
  G2Target target(const References& references, std::span<const Vector3> positions,
                  const References* at_sharp_edges = nullptr) const;
  /// Faces with a tension of vertices measure part of their bending over this surface. Does nothing where
  /// there are none.
  void bend_over(const References& references);

  const HalfEdgeMesh& mesh() const { return *mesh_; }
  const VertexFrames& frames() const { return frames_; }
  const std::shared_ptr<const G2Atlas>& atlas() const { return atlas_; }
  Index unknown_count() const { return unknowns_.count; }
  const FaceChart& chart(Index face) const { return charts_[face]->chart; }
  /// Number of a half-edge's side within its face's chart, and the half-edge of a side.
  int chart_side(Index half_edge) const { return chart_side_[half_edge]; }
  Index half_edge(Index face, int chart_side) const {
    return chart_half_edge_[mesh_->face_begin(face) + static_cast<Index>(chart_side)];
  }

  /// What positions, network and joins give. Without `sides` all that joins give is zero: the answer to a
  /// displacement, which they do not feel.
  struct Given {
    std::span<const Vector3> positions;
    const Network* network = nullptr;
    const GivenSides* sides = nullptr;
    const G2Target* target = nullptr;  ///< none: no curvature; the answer to a displacement
  };
  /// The sides must be those that the system was made for.
  GivenSides resolve(std::vector<GivenSide> sides) const {
    return resolve_given_sides(*mesh_, frames_, unknowns_, std::move(sides));
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

  /// All controls of a face: those of its chart, then seven Bezier points of each side's curve. Both faces of
  /// an edge get the same bits for its curve.
  G2Face controls(Index face, const Given& given, const Field& unknowns) const;

  /// Energy gradient of the condensed system at these unknowns for zero positions: A x. For tests.
  Field multiply(const Field& x) const;

  /// The network with the tangents that the surface has.
  Network network_of(const Given& given, const Field& unknowns) const;

  std::size_t chart_count() const;
  std::size_t element_count() const;
  /// Bytes of matrices, shared ones counted once.
  std::size_t matrix_bytes() const;

 private:
  struct Region;
  template <class Value>
  class Restricted;
  enum class Turn { plain, transposed, inverse, inverse_transposed };

  void weigh(const NetworkSystem& network);
  void choose_charts(const std::vector<GivenRibbon>& ribbons);
  void build_elements();
  Eigen::MatrixXd chart_energy(Index face, const SamplesOf<Jet3>& samples) const;
  /// Faces with equal charts one after the other, so that a chart's functions are computed once a task:
  /// body(face, samples).
  template <class Jet, class Body>
  void for_charts(std::vector<Index> faces, const Body& body) const;
  double target_share(Index face, std::span<const Vector3> positions) const;
  void build_blocks();
  std::vector<std::uintptr_t> block_key(Index face) const;
  PaddedMatrix make_block(Index face) const;
  std::shared_ptr<const Region> make_region(const std::vector<Index>* active_faces) const;
  Index slot_unknown(Index face, int slot) const;
  int turn_column(Index face, int slot, std::array<std::pair<int, double>, 3>& entry) const;
  int unknown_slots(Index face) const { return static_cast<int>(charts_[face]->places.unknown.size()); }
  /// In place: local vectors from unknowns to the face's controls, by its corners' turns and sides' signs.
  template <Turn which, class Value>
  void turn(Index face, Value* local) const;
  void given_controls(Index face, const Given& given, const Vector3& origin, Vector3* out) const;
  /// (g1, g2) of the corner at a half-edge's origin as the network has them; g2 zero at straight corners.
  std::array<Vector3, 2> network_frame(Index half_edge, const Network& network) const;
  /// Right-hand side of the tangents' terms, in the face's controls.
  void add_tangents(Index face, const Network& network, Vector3* local) const;
  /// Unknowns that are given, with their values.
  std::vector<std::pair<Index, Vector3>> known(const Given& given) const;
  std::array<Vector3, 2> corner_frame(Index half_edge, const Field& unknowns) const;
  std::array<Vector3, 7> edge_curve(Index edge, const Given& given, const Field& unknowns) const;
  Vector3 face_mean(Index face, const Given& given) const;

  template <class Value>
  Solution solve_in(std::shared_ptr<const Region> region, const Given& given, const SolveOptions& options,
                    const CancelToken& cancel) const;

  std::shared_ptr<const HalfEdgeMesh> mesh_;
  VertexFrames frames_;
  G2Unknowns unknowns_;
  G2Weights weights_;
  std::vector<bool> joined_;           ///< per unknown: joins give it
  std::vector<bool> joined_vertex_;    ///< per vertex; empty when there are no joins
  std::vector<bool> fixed_;            ///< per vertex: tangents are the network's; empty when none are
  std::vector<bool> given_;            ///< per unknown: it has a value already
  std::vector<Matrix3> inverse_turn_;  ///< per half-edge
  std::vector<Eigen::Matrix2d> inverse_tangent_turn_;
  std::vector<std::uint32_t> incidence_;                    ///< per unknown: faces that have it
  std::vector<CornerShape> shapes_;                         ///< per half-edge
  std::vector<std::shared_ptr<const PlacedChart>> charts_;  ///< per face
  std::vector<Index> chart_half_edge_;  ///< per corner of the face list: the half-edge of that chart side
  std::vector<int> chart_side_;         ///< per half-edge
  std::shared_ptr<const G2Atlas> atlas_;
  std::vector<FaceWeights> face_weights_;  ///< per face
  std::vector<double> over_reference_;     ///< per face: share of bending measured over the reference
  double reference_scale_ = 1;             ///< from bending over the reference to the charts'
  std::vector<double> tau_;                ///< per face
  std::vector<double> curve_weight_;       ///< per half-edge
  std::vector<double> tangent_weight_;     ///< per end (2 per half-edge)
  std::vector<std::shared_ptr<const CondensedFace>> element_;  ///< per face
  std::vector<std::shared_ptr<const PaddedMatrix>> block_;     ///< per face
  std::shared_ptr<const Region> whole_;
};

}  // namespace hariko
