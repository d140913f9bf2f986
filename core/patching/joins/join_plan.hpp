#pragma once

// JoinPlan: the conditions that the joined sides of a polyhedron impose on its network, and the control
// points that they prescribe (kuriyama.md section 8).

#include <map>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/network/network_system.hpp"
#include "core/patching/joins/join.hpp"
#include "core/patching/quartic/patch_constants.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Prescribed inner points of a patch, those that serve its joined side.
struct PrescribedSide {
  Index half_edge = no_index;
  Vector3 at_origin, at_target;  ///< D121u, D112u
};
/// Prescribed split tangent of a half-turn corner.
struct PrescribedSplit {
  Index half_edge = no_index;  ///< half-edge at the corner
  Vector3 tangent;
};
/// Control points and tangents prescribed by joins.
struct JoinGeometry {
  std::vector<PrescribedSide> sides;
  std::vector<PrescribedSplit> splits;
};

/// Coefficients of the G1 condition 4 (D(i,4-i,0) - D(i,3-i,1)) = 3 lambda (P(i,1) - P(i,0)) + B_i.
struct JoinCoefficients {
  double lambda = 1, l1 = 0, l2 = 0;
};

/// Plan of all joins of a polyhedron.
class JoinPlan {
 public:
  JoinPlan() = default;
  /// Plans joins of different border half-edges. Errors: E_JOIN_GAP (sides that share a vertex end in
  /// different points), E_JOIN_DEGENERATE (a side without a tangent or a tangent plane at its end),
  /// E_JOIN_CORNER (no common tangent plane at a vertex), E_JOIN_ANGLE (sides meet at an angle that no face
  /// can fill), E_JOIN_PINNED. Elements are vertices. O(joins log joins + vertices).
  static Result<JoinPlan> make(const Polyhedron& polyhedron, const Shaping& shaping, std::vector<Join> joins);

  bool empty() const { return joins_.empty(); }
  const std::vector<Join>& joins() const { return joins_; }  ///< ascending by half-edge
  /// Polyhedron whose ends of joined edges are moved to the ends of the sides.
  const Polyhedron& polyhedron() const { return *polyhedron_; }
  const std::vector<FrameRequest>& requests() const { return requests_; }
  std::vector<Index> half_edges() const;  ///< joined half-edges, ascending
  /// Whether any join requires a common tangent plane.
  bool any_smooth() const;
  /// Flags of the half-edges whose tangent planes are given; empty when there is none.
  std::vector<bool> smooth_sides() const;
  /// True when both plans lead to the same systems, whatever the positions.
  bool same_structure(const JoinPlan& other) const;

  /// Conditions known before the network is solved: the sides' tangents and, with G1, the planes of the basis
  /// vectors beside them.
  std::vector<BasisCondition> first_conditions(const VertexFrames& frames) const;

  struct Solution {
    /// Replace the first conditions: no vector is merely kept in a plane any more.
    std::vector<BasisCondition> conditions;
    JoinGeometry geometry;
    std::vector<JoinCoefficients> coefficients;  ///< one per join
    std::vector<Message> warnings;               ///< W_JOIN_SCALE
  };
  /// Solves for the coefficients. `basis`: the network's solution under the first conditions, changed as
  /// little as one lambda per side allows. Error: E_JOIN_TWIST names a vertex where the sides allow no such
  /// lambda.
  Result<Solution> solve(const VertexFrames& frames, const PatchConstants& constants,
                         std::span<const Vector3> basis) const;

 private:
  struct Vertex {
    int out = -1, in = -1;  ///< joins that leave and reach the vertex along the border; -1 for none
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
