#include "core/cad/fit/bezier_joint.hpp"

#include <array>
#include <cmath>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Control point `depth` rows inside from a side, at place `at` along it (counter-clockwise).
const Vector3& control(const BezierPatch& patch, int side, int at, int depth) {
  const int p = patch.degree_s;
  switch (side) {
    case 0:
      return patch.points[patch.index(at, depth)];
    case 1:
      return patch.points[patch.index(p - depth, at)];
    case 2:
      return patch.points[patch.index(p - at, p - depth)];
    default:
      return patch.points[patch.index(depth, p - at)];
  }
}

/// Nearest fraction of small whole numbers if x equals one but for rounding, else x.
double simple_fraction(double x) {
  constexpr double rounding = 1e-9;
  constexpr double most = 4096;
  double before = 0, numerator = 1, below = 1, denominator = 0, left = x;
  for (int round = 0; round < 12; ++round) {  // convergents of the continued fraction
    const double whole = std::floor(left);
    const double next = whole * numerator + before, under = whole * denominator + below;
    if (next > most || under > most) return x;
    before = numerator, numerator = next;
    below = denominator, denominator = under;
    if (std::abs(numerator / denominator - x) <= rounding * x) return numerator / denominator;
    left = 1 / (left - whole);
  }
  return x;
}

/// Control points of a curve, counted from one of its ends.
using Row = std::array<Vector3, max_bezier_degree + 1>;

/// Control point k of the piece that continues a polynomial beyond its first end and has `ratio` (at most 1)
/// of its width: k-fold extrapolation of its first k + 1 control points.
Vector3 continued(Row row, int k, double ratio) {
  for (int step = k; step > 0; --step)
    for (std::size_t i = 0; i < std::size_t(step); ++i) row[i] -= ratio * (row[i + 1] - row[i]);
  return row[0];
}

/// Whether the first `count` control points of the narrower row continue the other row; both begin where they
/// meet. The tolerance grows with extrapolation: control points off by `tolerance` are continued to control
/// point k with an error of (1 + 2 ratio)^k times as much.
bool agree(const Row& first, const Row& second, int count, double ratio, double tolerance) {
  const bool narrow_second = ratio <= 1;
  const Row &wide = narrow_second ? first : second, &narrow = narrow_second ? second : first;
  const double step = narrow_second ? ratio : 1 / ratio;
  for (int k = 0; k < count; ++k, tolerance *= 1 + 2 * step)
    if ((continued(wide, k, step) - narrow[std::size_t(k)]).norm() > tolerance) return false;
  return true;
}

/// Row of control points from a side into the patch.
Row row_across(const BezierPatch& patch, int side, int at) {
  Row out;
  for (int depth = 0; depth <= patch.degree_s; ++depth)
    out[std::size_t(depth)] = control(patch, side, at, depth);
  return out;
}
Row row_along(const BezierPatch& patch, int side, bool from_end) {
  Row out;
  for (int at = 0; at <= patch.degree_s; ++at)
    out[std::size_t(at)] = control(patch, side, from_end ? patch.degree_s - at : at, 0);
  return out;
}

}  // namespace

std::optional<double> spline_joint(const BezierPatch& first, int first_side, const BezierPatch& second,
                                   int second_side, double tolerance) {
  const int p = first.degree_s;
  HARIKO_ASSERT(first.degree_t == p && second.degree_s == p && second.degree_t == p && !first.rational() &&
                    !second.rational(),
                "polynomial patches of one degree");
  double longest = 0, beyond = 0;
  for (int at = 0; at <= p; ++at) {
    const double own = (control(first, first_side, at, 1) - control(first, first_side, at, 0)).norm();
    if (own <= longest) continue;
    longest = own;
    beyond = (control(second, second_side, p - at, 1) - control(second, second_side, p - at, 0)).norm();
  }
  if (!(longest > tolerance) || !(beyond > tolerance)) return {};
  const double ratio = simple_fraction(beyond / longest);
  for (int at = 0; at <= p; ++at)
    if (!agree(row_across(first, first_side, at), row_across(second, second_side, p - at), p, ratio,
               tolerance))
      return {};
  return ratio;
}

bool one_polynomial(const BezierPatch& first, int first_side, const BezierPatch& second, int second_side,
                    double ratio, double tolerance) {
  return agree(row_along(first, first_side, true), row_along(second, second_side, false), first.degree_s + 1,
               ratio, tolerance);
}

}  // namespace hariko
