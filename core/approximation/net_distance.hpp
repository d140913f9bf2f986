#pragma once

// How far a polynomial patch is from a facet, by its control points: the patch lies in their hull, and the
// distance to a triangle is convex, so the farthest control point bounds it.

#include "core/approximation/facet_nets.hpp"
#include "core/geometry/triangle.hpp"

namespace hariko {

class NetDistance {
 public:
  static constexpr int no_side = -1;
  /// Which side of the facet each side of a net lies on, where the curve over it is compared with that side;
  /// else no_side.
  using Sides = std::array<int, 3>;

  /// `net` is that of the whole facet. Borrows its points.
  NetDistance(const TriangleCorners& corners, const FacetNet& net, const Sides& sides);

  /// A certain bound, at most `tolerance` wherever bisecting the net can show that; else the bound above it
  /// that is known without.
  double decide(double tolerance);
  /// The largest distance of twelve points over the facet, about 0.93 of the truth or more.
  double sampled() const;
  /// The largest distance of points looked for where the bound is large, and a bound about 1 % above it.
  struct Range {
    double sampled = 0, bound = 0;
  };
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
