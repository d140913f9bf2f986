#include "core/patching/joins/g2_joins.hpp"

#include <algorithm>
#include <cmath>

#include "core/patching/joins/join_frame.hpp"

namespace hariko {

namespace {

class SideMaker {
 public:
  SideMaker(const JoinPlan& plan, const JoinPlan::Solution& joined, const VertexFrames& frames,
            const PatchConstants& constants, const Network& network)
      : mesh_(plan.polyhedron().topology()),
        plan_(plan),
        joined_(joined),
        frames_(frames),
        constants_(constants),
        network_(network),
        half_edges_(plan.half_edges()) {
    std::sort(half_edges_.begin(), half_edges_.end());
  }

  GivenSide make(std::size_t j) const {
    const Join& join = plan_.joins()[j];
    const auto& p = join.curve;
    GivenSide side;
    side.half_edge = join.half_edge;
    side.second_origin = 6 * (p[2] - 2 * p[1] + p[0]);
    side.second_target = 6 * (p[3] - 2 * p[2] + p[1]);
    if (join.continuity == Continuity::g0) return side;
    side.has_cross = true;
    const double factor = gain(join.half_edge);
    side.tangent_origin = straight_tangent(join.half_edge, factor);
    side.tangent_target = straight_tangent(mesh_.next(join.half_edge), factor);
    const double speed = 3 * joined_.coefficients[j].lambda / (factor * constants_.x[join.half_edge]);
    std::array<Vector3, 4> c;
    for (std::size_t i = 0; i < 4; ++i) c[i] = join.row[i] - p[i];
    const Vector3 first_a = 3 * (p[1] - p[0]), first_b = 3 * (p[3] - p[2]);
    const double la = (at_origin(side) + speed * c[0]).dot(first_a) / first_a.squaredNorm();
    const double lb = (at_target(side) + speed * c[3]).dot(first_b) / first_b.squaredNorm();
    side.cross_origin = -3 * speed * (c[1] - c[0]) + (lb - la) * first_a + la * side.second_origin;
    side.cross_target = -3 * speed * (c[3] - c[2]) + (lb - la) * first_b + lb * side.second_target;
    return side;
  }

 private:
  /// Split gain along the chain of joined sides that a half-edge belongs to. Half-turn corners have no gain
  /// of their own.
  double gain(Index half_edge) const {
    const auto turns = [&](Index corner) { return frames_.half_turn[corner]; };
    const auto joined = [&](Index h) {
      return std::binary_search(half_edges_.begin(), half_edges_.end(), h);
    };
    Index h = half_edge;
    while (turns(h) && joined(mesh_.previous(h)) && mesh_.previous(h) != half_edge) h = mesh_.previous(h);
    if (!turns(h)) return frames_.split_gain[h];
    h = half_edge;
    while (turns(mesh_.next(h)) && joined(mesh_.next(h)) && mesh_.next(h) != half_edge) h = mesh_.next(h);
    return turns(mesh_.next(h)) ? 1 : frames_.split_gain[mesh_.next(h)];
  }
  /// Second tangent of a half-turn corner: along the diagonal towards the middle of the face, the chart's
  /// derivative is three split tangents, over f diagonals.
  std::optional<Vector3> straight_tangent(Index corner, double factor) const {
    if (!is_straight(frames_.step[corner])) return std::nullopt;
    for (const PrescribedSplit& split : joined_.geometry.splits)
      if (split.half_edge == corner) return 3 * split.tangent / (factor * constants_.x[corner]);
    HARIKO_ASSERT(false, "joined half-turn corners have a given split tangent");
    return std::nullopt;
  }
  /// Cross derivative r1 at the side's ends.
  Vector3 at_origin(const GivenSide& side) const {
    if (side.tangent_origin) return *side.tangent_origin;
    const Index h = side.half_edge;
    return 3 * (network_.end[mesh_.previous(h)] - std::cos(frames_.step[h]) * network_.start[h]);
  }
  Vector3 at_target(const GivenSide& side) const {
    if (side.tangent_target) return *side.tangent_target;
    const Index h = side.half_edge, following = mesh_.next(h);
    return 3 * (network_.start[following] - std::cos(frames_.step[following]) * network_.end[h]);
  }

  const HalfEdgeMesh& mesh_;
  const JoinPlan& plan_;
  const JoinPlan::Solution& joined_;
  const VertexFrames& frames_;
  const PatchConstants& constants_;
  const Network& network_;
  std::vector<Index> half_edges_;  ///< joined half-edges, ascending
};

}  // namespace

std::vector<PrescribedRibbon> given_ribbons(const JoinPlan& plan) {
  std::vector<PrescribedRibbon> out;
  for (const Join& join : plan.joins()) {
    if (out.empty()) out.assign(plan.polyhedron().topology().half_edge_count(), PrescribedRibbon::none);
    out[join.half_edge] = join.continuity != Continuity::g0 ? PrescribedRibbon::cross
                          : join.patch_follows              ? PrescribedRibbon::curve_and_cubic_cross
                                                            : PrescribedRibbon::curve;
  }
  return out;
}

std::vector<GivenSide> given_sides(const JoinPlan& plan, const JoinPlan::Solution& joined,
                                   const VertexFrames& frames, const PatchConstants& constants,
                                   const Network& network) {
  const SideMaker maker(plan, joined, frames, constants, network);
  std::vector<GivenSide> out;
  for (std::size_t j = 0; j < plan.joins().size(); ++j) out.push_back(maker.make(j));
  return out;
}

}  // namespace hariko
