#pragma once

// Ties between the faces of smooth edges: common tangent planes, compared and corrected at places along each
// edge.

#include <cmath>
#include <functional>

#include "core/cad/cad_edges.hpp"
#include "core/cad/fit/face_fit.hpp"

namespace hariko {

/// Quantity that both faces of an edge are to have in common.
struct Agreed {
  std::array<SideTie, 2> tie;
  std::array<double, 2> has{};
  double wanted = 0;
  double limit = 0;                      ///< largest difference
  std::array<double, 2> weight{1, 1};    ///< parts of the faces' sides that the place stands for
  std::array<bool, 2> free{true, true};  ///< exact faces do not move

  /// Weighted mean of both faces' values, or the value of the exact face.
  double mean() const {
    if (!free[0] || !free[1]) return has[free[0] ? 1 : 0];
    return (weight[0] * has[0] + weight[1] * has[1]) / (weight[0] + weight[1]);
  }
  /// Cost of a unit of the squared difference from the mean.
  double cost() const { return (weight[0] + weight[1]) / (limit * limit); }
};

/// Place on a smooth edge, with the data of both faces there.
struct EdgePlace {
  double x = 0;  ///< parameter of the edge
  double width = 0;
  /// Unit normal of the surface, made perpendicular to the curve; zero where there is none.
  Vector3 normal = Vector3::Zero();
  /// Data of each face: `across` is the surface's derivative across the side, which the face keeps nearly;
  /// `speed` its component in the tangent plane and perpendicular to the edge.
  std::array<double, 2> speed{};
  std::array<Vector3, 2> across{};
  /// Weight in 0 .. 1 of the tangent plane: the smaller sine of the angle between the edge and the
  /// derivatives across it, divided by 0.05 and at most 1. It discounts ill-determined planes where sides of
  /// a corner run on straight.
  double sine = 1;
  Vector3 left = Vector3::Zero();  ///< unit, in the tangent plane and perpendicular to the curve
  Agreed turn;                     ///< rotation of the faces against the plane, radians
  double jump = 0;                 ///< angle between both faces, radians (not linear)

  Agreed bend;  ///< normal curvature across the edge, 1 / length; without ties where the surface's may jump
  double bend_jump = 0;  ///< between both faces, in multiples of the limit
};

/// Access to the faces being fitted.
struct FaceView {
  std::function<const SplineSurface&(Index)> surface;
  std::function<bool(Index)> free;  ///< whether the face is fitted; exact faces stay
};

/// Places along the smooth edges of a model, and the conditions at them that tie both faces to one plane.
class EdgeTies {
 public:
  EdgeTies(const EdgeTask& task, const CadEdges& edges, const FitLimits& limits, FaceView faces)
      : task_(task),
        edges_(edges),
        limits_(limits),
        faces_(std::move(faces)),
        places_(edges.edges().size()) {}

  /// Whether the edge is smooth and at least one of its faces is fitted.
  bool tied(Index edge) const;
  /// Chooses new places for the faces' present knots, keeping the planes of the old ones.
  void place(Index edge);
  /// Scales turns by the faces' own derivatives across the edge, which may differ in length from the
  /// surface's.
  void retie(Index edge);
  /// Reads the turns of both faces and the angle between them.
  void compare(Index edge);
  /// Angle between both faces at a place, in multiples of the limit.
  double miss(const EdgePlace& at) const { return at.sine * at.jump / limits_.angle; }
  /// Jump of the curvature across the edge at a place, in multiples of the limit.
  double bend_miss(const EdgePlace& at) const { return at.bend_jump; }
  /// Largest `miss` along an edge.
  double worst(Index edge) const;
  /// Largest `bend_miss` along an edge.
  double worst_bend(Index edge) const;
  /// Quantities that the faces of an edge are to have in common.
  void agreed(Index edge, std::vector<Agreed*>& out);
  /// Places along an edge; none where it ties no faces.
  std::vector<EdgePlace>& places(Index edge) { return places_[edge]; }
  const std::vector<EdgePlace>& places(Index edge) const { return places_[edge]; }
  /// Conditions of a fitted face; `wanted` gives their values in the same order.
  std::vector<FaceTie> ties(Index face) const;
  std::vector<double> wanted(Index face) const;
  /// Span of a face, along the side of a use, that contains a place of the edge.
  std::size_t span(const CadEdge& edge, int use, double x) const;

 private:
  template <class Visit>
  void for_places(Index face, const Visit& visit) const;
  double length(const CadUse& use) const { return (*task_.pieces)[use.piece].length(use.side); }
  /// Fraction of a side that a use covers.
  double share(const CadUse& use) const { return (use.end - use.begin) / length(use); }
  /// Parameter, counter-clockwise along the side of a use, of a place of the edge.
  static double on_side(const CadEdge& edge, int use, double x);
  /// Same parameter in the direction of growing s or t.
  double growing(const CadEdge& edge, int use, double x) const;
  std::vector<double> edge_breaks(const CadEdge& edge) const;
  PatchPoint side_point(const CadUse& use, double x) const;
  bool measure(const CadEdge& edge, EdgePlace& at) const;
  void tie_turn(const CadEdge& edge, EdgePlace& at) const;
  double narrowest(const CadEdge& edge, int use, double x, const PatchPoint& point) const;
  bool bends() const { return std::isfinite(limits_.bend); }
  void tie_bend(const CadEdge& edge, EdgePlace& at, int use, const PatchPoint& face) const;

  const EdgeTask& task_;
  const CadEdges& edges_;
  FitLimits limits_;
  FaceView faces_;
  std::vector<std::vector<EdgePlace>> places_;  ///< by edge; only edges that tie faces have some
};

}  // namespace hariko
