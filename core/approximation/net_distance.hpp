#pragma once

// NetDistance: the distance of a polynomial patch from a facet by its control points: the patch lies in their
// hull, and the distance to a triangle is convex, so the farthest control point bounds it.

#include "core/approximation/refinement/facet_control_nets.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

/// Distance of one polynomial patch from one facet.
class NetDistance {
 public:
  static constexpr int no_side = -1;
  /// Side of the facet for each side of a net over which the curve is compared with that side; otherwise
  /// no_side.
  using Sides = std::array<int, 3>;

  /// `net` is that of the whole facet; its points are kept by reference.
  NetDistance(const TriangleCorners& corners, const FacetNet& net, const Sides& sides);

  /// Certain bound, at most `tolerance` wherever bisecting the net can show that; otherwise the bound of the
  /// net as it is.
  double decide(double tolerance);
  /// Largest distance at twelve points over the facet, at least about 0.93 of the true value.
  double sampled() const;
  /// Largest distance at points sampled where the bound is large, and a bound about 1 % above it.
  struct Range {
    double sampled = 0, bound = 0;
  };
  /// Measures the distance, with the effort of a report.
  Range measure();

 private:
  /// Control points of a piece, on the stack of a recursion.
  struct Piece {
    std::array<Vector3, TriangleNet::max_count> points;
    Sides sides;
  };
  double bound_of(const Vector3* points, const Sides& sides) const;
  int side_to_halve(const Vector3* points) const;
  double at_point(const Vector3& p, int side) const;
  void halve(const Vector3* points, const Sides& sides, Piece& first, Piece& second, double& middle) const;
  double within(const Vector3* points, const Sides& sides, double tolerance, int depth) const;
  double narrowed(const Vector3* points, const Sides& sides, double bound, int depth, double& sampled) const;

  TriangleCorners corners_;
  ClosedTriangle closed_;
  FacetNet net_;
  Sides sides_;
};

}  // namespace hariko
