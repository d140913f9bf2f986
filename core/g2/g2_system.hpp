#pragma once

// G2System: the linear system of mode G2, assembled once per connectivity, tags and tensions, solved for any
// positions (g2.md sections 5 and 6).

#include <memory>
#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/g2/face_energy.hpp"
#include "core/g2/g2_patch_set.hpp"
#include "core/g2/given_sides.hpp"
#include "core/g2/round_energy.hpp"
#include "core/g2/unknowns.hpp"
#include "core/network/network_system.hpp"

namespace hariko {

/// Faces with more sides bend over their charts always: measured over a surface they beat up waves (g2.md
/// section 9).
inline constexpr Index largest_round_side_count = 12;

/// Every face is a dense matrix over the unknowns of its corners and sides, with its centre eliminated; equal
/// faces share one. The matrix of the whole is never stored. Conjugate gradients precondition with the exact
/// inverses of overlapping blocks, one a face.
class G2System {
 public:
  /// `ribbons`, per half-edge: what joins give; empty when there are none.
  G2System(std::shared_ptr<const HalfEdgeMesh> mesh, const NetworkSystem& network,
           const G2Weights& weights = {}, const std::vector<GivenRibbon>& ribbons = {});
  ~G2System();

  /// Measures bending over this surface instead of over the faces' charts ("round", g2.md section 8): patch h
  /// belongs to half-edge h, corners: centre, origin, target. O(faces), slow:
  /// no two faces are equal then.
  void bend_over(const ReferencePoints& reference);
  void bend_over_charts();
  bool round() const { return round_; }

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

  std::size_t chart_count() const { return elements_.chart_count(); }
  std::size_t element_count() const;
  /// Bytes of matrices, shared ones counted once.
  std::size_t matrix_bytes() const;

 private:
  struct Region;
  template <class Value>
  class Restricted;
  enum class Turn { plain, transposed, inverse, inverse_transposed };

  void choose_charts(const NetworkSystem& network, const G2Weights& weights,
                     const std::vector<GivenRibbon>& ribbons);
  std::vector<double> curve_weights(Index face) const;
  void build_blocks();
  std::vector<std::uintptr_t> block_key(Index face) const;
  PaddedMatrix make_block(Index face) const;
  std::shared_ptr<const Region> make_region(const std::vector<Index>* active_faces) const;
  Index slot_unknown(Index face, int slot) const;
  int unknown_slots(Index face) const { return static_cast<int>(charts_[face]->places.unknown.size()); }
  /// In place: local vectors from unknowns to the face's controls, by its corners' turns and sides' signs.
  template <Turn which, class Value>
  void turn(Index face, Value* local) const;
  void given_controls(Index face, const Given& given, const Vector3& origin, Vector3* out) const;
  std::array<Vector3, 7> edge_curve(Index edge, const Given& given, const Field& unknowns) const;
  Vector3 face_mean(Index face, const Given& given) const;

  template <class Value>
  Solution solve_in(std::shared_ptr<const Region> region, const Given& given, const SolveOptions& options,
                    const CancelToken& cancel) const;

  std::shared_ptr<const HalfEdgeMesh> mesh_;
  VertexFrames frames_;
  G2Unknowns unknowns_;
  std::vector<bool> given_;               ///< per unknown: joins give it
  std::vector<Matrix3> inverse_turn_;     ///< per half-edge
  std::vector<std::uint32_t> incidence_;  ///< per unknown: faces that have it
  G2Elements elements_;
  std::vector<std::shared_ptr<const ChartEnergy>> charts_;  ///< per face
  std::vector<Index> chart_half_edge_;  ///< per corner of the face list: the half-edge of that chart side
  std::vector<int> chart_side_;         ///< per half-edge
  std::shared_ptr<const G2Atlas> atlas_;
  std::vector<double> tau_;                                    ///< per face
  std::vector<double> curve_weight_;                           ///< per half-edge
  std::vector<std::shared_ptr<const CondensedFace>> element_;  ///< per face
  std::vector<std::shared_ptr<const PaddedMatrix>> block_;     ///< per face
  std::shared_ptr<const Region> whole_;
  bool round_ = false;
};

}  // namespace hariko
