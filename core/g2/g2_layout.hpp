#pragma once

// G2Layout: the numbering of mode G2's unknowns in the local vectors of faces (g2.md sections 2 and 6).

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/g2/degrees_of_freedom.hpp"
#include "core/g2/faces/chart_choice.hpp"
#include "core/g2/g2_patch_set.hpp"
#include "core/network/vertex_frames.hpp"

namespace hariko {

/// Layout of local vectors. A face's local vector has its unknowns in the order of `ControlPlaces::unknown`.
/// Its controls are the unknowns transformed by the corners' maps and multiplied by the sides' signs.
class G2Layout {
 public:
  G2Layout(std::shared_ptr<const HalfEdgeMesh> mesh, const VertexFrames& frames,
           const TensionWeights& weights, const std::vector<PrescribedRibbon>& ribbons);

  const HalfEdgeMesh& mesh() const { return *mesh_; }
  const VertexFrames& frames() const { return frames_; }
  const G2Unknowns& unknowns() const { return unknowns_; }
  const std::shared_ptr<const G2Atlas>& atlas() const { return atlas_; }
  /// Shape of the corner at a half-edge's origin.
  const CornerShape& corner(Index half_edge) const { return corners_[half_edge]; }

  const std::shared_ptr<const PlacedChart>& placed(Index face) const { return charts_.placed[face]; }
  const FaceChart& chart(Index face) const { return charts_.placed[face]->chart; }
  const ControlPlaces& places(Index face) const { return charts_.placed[face]->places; }
  /// Number of a half-edge's side within its face's chart; `half_edge` is the inverse.
  int chart_side(Index half_edge) const { return charts_.side[half_edge]; }
  Index half_edge(Index face, int chart_side) const {
    return charts_.half_edge[mesh_->face_begin(face) + static_cast<Index>(chart_side)];
  }

  /// Number of a face's unknowns; `slot_unknown` is the global number of each.
  int slot_count(Index face) const { return static_cast<int>(places(face).unknown.size()); }
  Index slot_unknown(Index face, int slot) const;
  /// Number of faces that have each unknown.
  const std::vector<std::uint32_t>& incidence() const { return incidence_; }

  /// Column of the transformation: the controls of the face that one of its unknowns moves, with factors.
  /// Returns their number.
  int turn_column(Index face, int slot, std::array<std::pair<int, double>, 3>& entry) const;
  enum class Turn { plain, transposed, inverse, inverse_transposed };
  /// Transforms a local vector from unknowns to the face's controls, in place.
  template <Turn which, class Value>
  void turn(Index face, Value* local) const;
  /// Inverse map from the derivatives of the corner at a half-edge's origin to their unknowns.
  const Eigen::Matrix2d& inverse_tangent_turn(Index half_edge) const {
    return inverse_tangent_turn_[half_edge];
  }

 private:
  std::shared_ptr<const HalfEdgeMesh> mesh_;
  VertexFrames frames_;
  G2Unknowns unknowns_;
  std::vector<CornerShape> corners_;  ///< per half-edge
  ChartChoice charts_;
  std::shared_ptr<const G2Atlas> atlas_;
  std::vector<Matrix3> inverse_turn_;  ///< per half-edge
  std::vector<Eigen::Matrix2d> inverse_tangent_turn_;
  std::vector<std::uint32_t> incidence_;
};

template <G2Layout::Turn which, class Value>
void G2Layout::turn(Index face, Value* local) const {
  constexpr bool inverse = which == Turn::inverse || which == Turn::inverse_transposed;
  constexpr bool transposed = which == Turn::transposed || which == Turn::inverse_transposed;
  const int n = static_cast<int>(mesh_->side_count(face));
  for (int j = 0; j < n; ++j) {
    const Index h = half_edge(face, j);
    const Matrix3& m = inverse ? inverse_turn_[h] : unknowns_.corner[h].turn;
    const auto at = [&](int i, int k) { return transposed ? m(k, i) : m(i, k); };
    Value* x = local + 3 * j;
    const Value a = x[0], b = x[1], c = x[2];
    for (int i = 0; i < 3; ++i) x[i] = at(i, 0) * a + at(i, 1) * b + at(i, 2) * c;
    const auto& sign = unknowns_.side[h].sign;
    for (int i = 0; i < 5; ++i) local[3 * n + 5 * j + i] *= sign[std::size_t(i)];
  }
  for (int j = 0; j < n; ++j) {
    const Index h = half_edge(face, j);
    const Eigen::Matrix2d& m = inverse ? inverse_tangent_turn_[h] : unknowns_.corner[h].tangent_turn;
    Value* x = local + 8 * n + 2 * j;
    const Value a = x[0], b = x[1];
    x[0] = m(0, 0) * a + (transposed ? m(1, 0) : m(0, 1)) * b;
    x[1] = (transposed ? m(0, 1) : m(1, 0)) * a + m(1, 1) * b;
  }
}

}  // namespace hariko
