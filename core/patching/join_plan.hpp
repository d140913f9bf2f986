#pragma once

// JoinPlan: what the joined sides of a polyhedron ask of its network, and the control points that they give
// (kuriyama.md section 8).

#include <map>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/join.hpp"
#include "core/patching/patch_constants.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// The inner points of a patch that serve its joined side.
struct PrescribedSide {
  Index half_edge = no_index;
  Vector3 at_origin, at_target;  ///< D121u, D112u
};
/// A half-turn corner's split tangent.
struct PrescribedSplit {
  Index half_edge = no_index;  ///< of the corner
  Vector3 tangent;
};
struct JoinGeometry {
  std::vector<PrescribedSide> sides;
  std::vector<PrescribedSplit> splits;
};

/// The coefficients of 4 (D(i,4-i,0) - D(i,3-i,1)) = 3 lambda (P(i,1) - P(i,0)) + B_i.
struct JoinCoefficients {
  double lambda = 1, l1 = 0, l2 = 0;
};

class JoinPlan {
 public:
  JoinPlan() = default;
  /// Joins name different border half-edges. Errors: E_JOIN_GAP (sides that share a vertex end in different
  /// points), E_JOIN_DEGENERATE (a side without a tangent or a tangent plane at its end), E_JOIN_CORNER (no
  /// common tangent plane at a vertex), E_JOIN_ANGLE (sides meet at an angle that no face can fill),
  /// E_JOIN_PINNED. Elements are vertices. O(joins log joins + vertices).
  static Result<JoinPlan> make(const Polyhedron& polyhedron, const Shaping& shaping, std::vector<Join> joins);

  bool empty() const { return joins_.empty(); }
  const std::vector<Join>& joins() const { return joins_; }  ///< ascending by half-edge
  /// The polyhedron with the ends of joined edges where the sides end.
  const Polyhedron& polyhedron() const { return *polyhedron_; }
  const std::vector<FrameRequest>& requests() const { return requests_; }
  std::vector<Index> half_edges() const;  ///< joined ones, ascending
  bool any_smooth() const;
  /// Half-edges whose tangent planes are given, as a flag each; empty when there are none.
  std::vector<bool> smooth_sides() const;
  /// Both lead to the same systems, whatever the positions.
  bool same_structure(const JoinPlan& other) const;

  /// Known before the network is solved: the sides' tangents and, with G1, the planes of what lies beside
  /// them.
  std::vector<BasisCondition> first_conditions(const VertexFrames& frames) const;

  struct Solution {
    std::vector<BasisCondition> conditions;  ///< replace the first ones: nothing is left in a plane
    JoinGeometry geometry;
    std::vector<JoinCoefficients> coefficients;  ///< one a join
    std::vector<Message> warnings;               ///< W_JOIN_SCALE
  };
  /// `basis`: the network's solution under the first conditions, from which it departs as little as one
  /// lambda for each side allows. Error: E_JOIN_TWIST names a vertex where the sides leave no such lambda.
  Result<Solution> solve(const VertexFrames& frames, const PatchConstants& constants,
                         std::span<const Vector3> basis) const;

 private:
  struct Vertex {
    int out = -1, in = -1;  ///< joins that leave and reach the vertex along the border
    std::size_t corners = 0, creases = 0;
  };
  struct End;
  class Solver;

  std::optional<Message> move_vertices(const Polyhedron& polyhedron);
  std::optional<Message> check_vertex(Index v, const Vertex& vertex);
  std::optional<Message> request_frame(Index v, const Vertex& vertex);
  Vector3 face_normal(Index v) const;
  std::string name(Index v) const;

  std::vector<Join> joins_;
  std::optional<Polyhedron> polyhedron_;
  std::map<Index, Vertex> vertices_;
  std::vector<FrameRequest> requests_;
};

}  // namespace hariko
