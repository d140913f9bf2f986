#pragma once

// Subdivision curves: uniform cubic B-splines with natural ends, drawn by control points or by interpolated
// points.

#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Subdivision curve, refined by the rules of Catmull and Clark: edge point = midpoint, vertex point = (1, 6,
/// 1) / 8; ends of open curves and sharp points stay. Parameters run over [0, 1]; control point i corresponds
/// to i / spans(). Open curves have at least one point (one point is a constant), closed ones at least three.
struct SubdivisionCurve {
  std::vector<Vector3> points;
  bool closed = false;
  std::vector<char> sharp;  ///< empty, or one per point: nonzero is a corner

  int size() const { return int(points.size()); }
  /// Number of intervals between control points.
  int spans() const { return closed ? size() : size() - 1; }
  double parameter(int point) const { return spans() > 0 ? double(point) / spans() : 0.0; }
  bool is_sharp(int point) const { return !sharp.empty() && sharp[std::size_t(point)] != 0; }
  /// Whether the curve passes through the control point: open ends and corners.
  bool is_fixed(int point) const {
    return is_sharp(point) || (!closed && (point == 0 || point == size() - 1));
  }
  friend bool operator==(const SubdivisionCurve&, const SubdivisionCurve&) = default;
};

/// Position and derivatives of a curve at a parameter.
struct CurvePoint {
  Vector3 position = Vector3::Zero(), first = Vector3::Zero(), second = Vector3::Zero();
};

/// Evaluates position and derivatives with respect to the parameter. Closed curves repeat outside of [0, 1],
/// open ones are extrapolated by their end spans. At a corner the derivatives are those of the following
/// span. O(1).
CurvePoint evaluate(const SubdivisionCurve& curve, double u);

/// Limit point of each control point: (1, 4, 1) / 6, or itself where the curve is fixed. O(n).
std::vector<Vector3> limit_points(const SubdivisionCurve& curve);

/// Linear system from control points to limit points, factorised once for many right-hand sides. Rows are (1,
/// 4, 1) / 6, cyclic when closed, and identity where `fixed`. Condition at most about 3. O(n) per solve.
class LimitSystem {
 public:
  /// Factorises the system. `fixed`: one per point; ends of open curves must be fixed.
  LimitSystem(std::vector<char> fixed, bool closed);
  explicit LimitSystem(const SubdivisionCurve& curve);

  int size() const { return int(fixed_.size()); }
  /// Replaces the values at data[0], data[stride], ... (one per point) by the solution.
  void solve(Vector3* data, std::size_t stride = 1) const;

 private:
  void solve_tridiagonal(Vector3* data, std::size_t stride) const;
  std::vector<char> fixed_;
  bool closed_;
  std::vector<double> lower_, inverse_, upper_;
  // Cyclic entries as a rank-one correction (Sherman and Morrison).
  double corner_ratio_ = 0, scale_ = 0;
  std::vector<double> correction_;
};

/// Curve with the limit points `targets`, for drawing through points. O(n).
SubdivisionCurve curve_through(std::vector<Vector3> targets, bool closed, std::vector<char> sharp = {});

/// Curve with twice as many spans. Exact.
SubdivisionCurve refined(const SubdivisionCurve& curve);

/// Edited curve and its largest distance from the old one at sampled points.
struct Reshaped {
  SubdivisionCurve curve;
  double deviation = 0;
};
/// Inserts a control point in the middle of a span: the curve through the old limit points and the curve
/// point there. Uniform curves have no exact insertion of one knot.
Reshaped with_point_inserted(const SubdivisionCurve& curve, int span);
/// Deletes a control point: the curve through the other limit points. At least two points (closed: three)
/// must be left.
Reshaped with_point_deleted(const SubdivisionCurve& curve, int point);

/// Parameter and distance of the point of the curve nearest to `target`, by sampling and Newton steps.
struct CurveFoot {
  double parameter = 0, distance = 0;
};
/// Nearest point of a curve. O(spans).
CurveFoot nearest_point(const SubdivisionCurve& curve, const Vector3& target);

/// Length as the sum of the chords between 16 samples per span.
double length(const SubdivisionCurve& curve);

}  // namespace hariko
