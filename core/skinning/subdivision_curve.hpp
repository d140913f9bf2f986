#pragma once

// Subdivision curves: uniform cubic B-splines with natural ends, drawn by control points or through points.

#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Refined by the rules of Catmull and Clark: edge point = midpoint, vertex point = (1, 6, 1) / 8; ends of
/// open curves and sharp points stay. Parameters run over [0, 1]; control point i belongs to i / spans().
/// Open curves have at least one point (one point is a constant), closed ones at least three.
struct SubdivisionCurve {
  std::vector<Vector3> points;
  bool closed = false;
  std::vector<char> sharp;  ///< empty, or one a point: nonzero is a corner

  int size() const { return int(points.size()); }
  /// Intervals between control points.
  int spans() const { return closed ? size() : size() - 1; }
  double parameter(int point) const { return spans() > 0 ? double(point) / spans() : 0.0; }
  bool is_sharp(int point) const { return !sharp.empty() && sharp[std::size_t(point)] != 0; }
  /// The curve passes through the control point: open ends and corners.
  bool is_fixed(int point) const {
    return is_sharp(point) || (!closed && (point == 0 || point == size() - 1));
  }
  friend bool operator==(const SubdivisionCurve&, const SubdivisionCurve&) = default;
};

struct CurvePoint {
  Vector3 position = Vector3::Zero(), first = Vector3::Zero(), second = Vector3::Zero();
};

/// Position and derivatives with respect to the parameter. Closed curves repeat outside of [0, 1], open ones
/// go on with their end spans. At a corner the span after it decides. O(1).
CurvePoint evaluate(const SubdivisionCurve& curve, double u);

/// Limit point of each control point: (1, 4, 1) / 6, or itself where the curve is fixed. O(n).
std::vector<Vector3> limit_points(const SubdivisionCurve& curve);

/// The matrix that takes control points to their limit points, factorised once for many right sides. Rows are
/// (1, 4, 1) / 6, cyclic when closed, and identity where `fixed`. Condition at most about 3. O(n) a solve.
class LimitSystem {
 public:
  /// `fixed`: one a point; ends of open curves must be fixed.
  LimitSystem(std::vector<char> fixed, bool closed);
  explicit LimitSystem(const SubdivisionCurve& curve);

  int size() const { return int(fixed_.size()); }
  /// Replaces the values at data[0], data[stride], ... (one a point) by the solution.
  void solve(Vector3* data, std::size_t stride = 1) const;

 private:
  void solve_tridiagonal(Vector3* data, std::size_t stride) const;
  std::vector<char> fixed_;
  bool closed_;
  std::vector<double> lower_, inverse_, upper_;
  // The cyclic entries as a rank-one correction (Sherman and Morrison).
  double corner_ratio_ = 0, scale_ = 0;
  std::vector<double> correction_;
};

/// The curve whose limit points are `targets`: drawing through points. O(n).
SubdivisionCurve curve_through(std::vector<Vector3> targets, bool closed, std::vector<char> sharp = {});

/// The same curve with twice as many spans. Exact.
SubdivisionCurve refined(const SubdivisionCurve& curve);

/// One more point in the middle of a span: the curve through the old limit points and that one. Uniform
/// curves have no exact insertion of one knot; `deviation` is how far the curves are apart at sampled points.
struct Reshaped {
  SubdivisionCurve curve;
  double deviation = 0;
};
Reshaped with_point_inserted(const SubdivisionCurve& curve, int span);
/// The curve through the other limit points. At least two points (closed: three) must be left.
Reshaped with_point_deleted(const SubdivisionCurve& curve, int point);

/// Parameter and distance of the point of the curve nearest to `target`. Samples, then Newton steps.
struct CurveFoot {
  double parameter = 0, distance = 0;
};
CurveFoot nearest_point(const SubdivisionCurve& curve, const Vector3& target);

/// Sum of the chords between 16 samples a span.
double length(const SubdivisionCurve& curve);

/// The open curve as a clamped cubic B-spline: n + 2 control points over the knots 0,0,0,0,1,..,n-2,n-1 x 4.
/// Exact; the curve must be open, without corners inside, and have at least two points.
std::vector<Vector3> clamped_control_points(const SubdivisionCurve& curve);

}  // namespace hariko
