#pragma once

// Tangent planes, and curvatures where they are to be continuous, that both faces of each smooth edge are
// tied to.

#include <functional>

#include "core/cad/cad_edges.hpp"
#include "core/cad/face_fit.hpp"

namespace hariko {

/// A number that both faces of an edge are to have in common.
struct Agreed {
  std::array<SideTie, 2> tie;
  std::array<double, 2> has{};
  double wanted = 0;
  double limit = 0;                      ///< of the difference
  std::array<double, 2> weight{1, 1};    ///< parts of the sides
  std::array<bool, 2> free{true, true};  ///< exact faces stay

  /// The value that those of both faces are nearest to.
  double mean() const {
    if (!free[0] || !free[1]) return has[free[0] ? 1 : 0];
    return (weight[0] * has[0] + weight[1] * has[1]) / (weight[0] + weight[1]);
  }
  /// The cost of a unit of the squared difference from the mean.
  double cost() const { return (weight[0] + weight[1]) / (limit * limit); }
};

/// A place of a smooth edge, with what both faces have there.
struct EdgePlace {
  double x = 0;  ///< of the edge
  double width = 0;
  Vector3 normal = Vector3::Zero();  ///< the surface's, perpendicular to the curve; zero where there is none
  /// A value for each face: the part of its derivative across the side that is in the plane and perpendicular
  /// to the boundary; and that derivative of the surface, which the face keeps nearly.
  std::array<double, 2> speed{};
  std::array<Vector3, 2> across{};
  /// The lesser sine between the edge and the derivatives across it, at most 0.05, in parts of that: hardly
  /// determined planes, where sides of a corner run on straight, count little.
  double sine = 1;
  Vector3 left = Vector3::Zero();  ///< unit, in the plane and perpendicular to the curve
  Agreed turn;                     ///< against the plane, radians
  double jump = 0;                 ///< between both faces, radians, not linear
};

/// The faces that are being made, as ties see them.
struct FaceView {
  std::function<const SplineSurface&(Index)> surface;
  std::function<bool(Index)> free;  ///< it is fitted; else it is exact and stays
};

class EdgeTies {
 public:
  EdgeTies(const EdgeTask& task, const CadEdges& edges, const FitLimits& limits, FaceView faces)
      : task_(task),
        edges_(edges),
        limits_(limits),
        faces_(std::move(faces)),
        places_(edges.edges().size()) {}

  /// The edge is smooth and one of its faces is free.
  bool tied(Index edge) const;
  /// Takes new places for the faces' knots, with the planes of the old ones.
  void place(Index edge);
  /// Measures turns by the derivatives that the faces have across the edge, which need not be as long as the
  /// surface's.
  void retie(Index edge);
  /// Reads what both faces have.
  void compare(Index edge);
  /// How many times the limit both faces differ in a place, and at most.
  double miss(const EdgePlace& at) const { return at.sine * at.jump / limits_.angle; }
  double worst(Index edge) const;
  std::vector<EdgePlace>& places(Index edge) { return places_[edge]; }
  const std::vector<EdgePlace>& places(Index edge) const { return places_[edge]; }
  /// Conditions of a free face; `wanted` gives their values in the same order.
  std::vector<FaceTie> ties(Index face) const;
  std::vector<double> wanted(Index face) const;
  /// The span of a face along the side of a use, of a place of the edge.
  std::size_t span(const CadEdge& edge, int use, double x) const;

 private:
  template <class Visit>
  void for_places(Index face, const Visit& visit) const;
  double length(const CadUse& use) const { return (*task_.pieces)[use.piece].length(use.side); }
  /// Part of a side that an edge is.
  double share(const CadUse& use) const { return (use.end - use.begin) / length(use); }
  /// Counter-clockwise along the side of a use, of a place of the edge.
  static double on_side(const CadEdge& edge, int use, double x);
  /// In the direction of growing s or t.
  double growing(const CadEdge& edge, int use, double x) const;
  std::vector<double> edge_breaks(const CadEdge& edge) const;
  PatchPoint side_point(const CadUse& use, double x) const;
  bool measure(const CadEdge& edge, EdgePlace& at) const;
  void tie_turn(const CadEdge& edge, EdgePlace& at) const;

  const EdgeTask& task_;
  const CadEdges& edges_;
  FitLimits limits_;
  FaceView faces_;
  std::vector<std::vector<EdgePlace>> places_;  ///< of each edge that ties faces
};

}  // namespace hariko
