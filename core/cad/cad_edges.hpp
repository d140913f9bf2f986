#pragma once

// Edge curves of a CAD model, shared by the faces that meet there.

#include "core/base/cancellation.hpp"
#include "core/cad/cad_model.hpp"
#include "core/cad/fit/curve_fit.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Input for the edges of a CAD model.
struct EdgeTask {
  const std::vector<CadPiece>* pieces = nullptr;
  const std::vector<PieceEvaluator>* points = nullptr;  ///< one evaluator per piece
  int degree = 3;
  FitLimits limits;
  double size = 0;
  /// Distance (a length) below which a spline counts as the surface itself: numbers from a file are rounded,
  /// and continuing a polynomial multiplies the error.
  double rounding = 0;
  /// Whether no face is exactly a spline: curves may then leave the surface's own, also where those are
  /// splines.
  bool bends = false;
};

/// Edges and vertices of a CAD model, and the boundary curves that its faces take from them.
class CadEdges {
 public:
  /// Fits the curves of all edges of the plan. The result is of no use once `cancel` is cancelled. O(pieces).
  CadEdges(const EdgeTask& task, const CadPlan& plan, const CancelToken& cancel);

  const std::vector<CadEdge>& edges() const { return edges_; }
  const std::vector<Vector3>& vertices() const { return vertices_; }
  /// Edges along the four sides of a piece, counter-clockwise.
  const std::array<std::vector<Index>, 4>& sides(Index piece) const { return sides_[piece]; }
  /// Curve along a side of a piece, counter-clockwise, over the side's parameter from 0 on.
  SplineCurve side_curve(Index piece, int side) const;
  /// Control points along a side in the direction of growing s or t, in a space that holds the side's curve.
  /// The system is solved in the direction of the edge, so that both of its faces get the same bits from the
  /// same knots.
  std::vector<Vector3> boundary(Index piece, int side, const SplineSpace& space) const;
  /// Breaks of the curve along a side, in the direction of growing s or t.
  std::vector<double> breaks(Index piece, int side) const;

 private:
  const CadPiece& piece(const CadUse& use) const { return (*task_.pieces)[use.piece]; }
  double length(const CadUse& use) const { return piece(use).length(use.side); }
  bool whole(const CadUse& use) const { return use.begin == 0 && use.end == length(use); }
  /// Whether the end (or else the beginning) of a use is that of its side.
  bool ends_side(const CadUse& use, bool at_end) const {
    return at_end ? use.end == length(use) : use.begin == 0;
  }
  bool is_first(const CadEdge& edge, Index piece, int side) const {
    return edge.uses[0].piece == piece && edge.uses[0].side == side;
  }
  /// Differential data of the surface at an end of an edge.
  struct End {
    Vector3 direction = Vector3::Zero();  ///< unit, away from the vertex
    Vector3 normal = Vector3::Zero();     ///< unit; zero where there is none
    double bend = 0;                      ///< normal curvature along the edge
    std::optional<double> wanted = {};    ///< normal curvature that the fitted curve is to have
  };
  End end_of(const CadEdge& edge, bool at_end) const;
  struct EdgeEnd {
    Index edge;
    bool at_end;
  };
  /// Faces round a vertex between which only smooth edges lie, with the ends of all their edges there.
  struct Sector {
    std::vector<EdgeEnd> ends;
    bool creased = false;  ///< an edge is a crease
    bool torn = false;     ///< the vertex lies within a side of another face
    bool closed = true;    ///< no edge is a border
  };
  std::vector<Sector> sectors() const;
  std::optional<Index> corner_of(const CadEdge& edge, std::size_t use, bool at_end) const;
  void bend_ends();
  void bend_sector(const Sector& sector, const std::vector<End>& ends, const Vector3& normal);
  std::optional<End>& end_at(const CadEdge& edge, std::size_t use, bool at_end) {
    const CadUse& own = edge.uses[use];
    return ends_[own.piece][std::size_t(own.side)][(use == 0) == at_end ? 1 : 0];
  }
  TracedPoint side_point(Index piece, int side, double x, bool smooth) const;
  FittedCurve curve(const SplineSpace& spline, const SplineSpace& start, Index piece, int side,
                    bool smooth) const;
  void take(const CadPlan& plan);
  void fit_divided_sides(const CancelToken& cancel);
  void fit(CadEdge& edge) const;
  SplineCurve part(const CadUse& use) const;
  void take_vertices(Index count);
  SplineCurve along(const CadEdge& edge, Index piece, int side) const;

  EdgeTask task_;
  std::vector<CadEdge> edges_;
  std::vector<Vector3> vertices_;
  std::vector<std::array<std::vector<Index>, 4>> sides_;  ///< edges of the sides of each piece
  std::vector<std::array<SplineCurve, 4>> divided_;       ///< curves of sides with several edges, by piece
  /// Normals and normal curvatures prescribed at both ends of each side's curve, counter-clockwise.
  std::vector<std::array<std::array<std::optional<End>, 2>, 4>> ends_;
};

/// Fraction of the distance tolerance that curves between faces may use.
inline constexpr double curve_share = 0.4;

/// Adds a break unless one is there already, to rounding.
void insert_break(std::vector<double>& breaks, double at);

}  // namespace hariko
