#include "core/gaussmap/outlines/loop_curve.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hariko {
namespace {

/// Derivatives at the points of a closed sequence by the parabola through three of them.
template <class T>
std::vector<T> slopes(const std::vector<T>& values, const std::vector<double>& chords) {
  const std::size_t count = values.size();
  std::vector<T> out;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t previous = (i + count - 1) % count, next = (i + 1) % count;
    const double before = chords[previous], after = chords[i];
    out.push_back(
        (after / before * (values[i] - values[previous]) + before / after * (values[next] - values[i])) /
        (before + after));
  }
  return out;
}

template <class T>
T hermite(const T& from, const T& slope_from, const T& to, const T& slope_to, double length, double x) {
  const double y = 1 - x;
  return y * y * (1 + 2 * x) * from + x * x * (1 + 2 * y) * to +
         length * (x * y * y * slope_from - x * x * y * slope_to);
}

/// Derivative of `hermite` by x, divided by the length.
template <class T>
T hermite_slope(const T& from, const T& slope_from, const T& to, const T& slope_to, double length, double x) {
  return 6 * x * (1 - x) / length * (to - from) + (1 - x) * (1 - 3 * x) * slope_from +
         x * (3 * x - 2) * slope_to;
}

Vector3 perpendicular(const Vector3& v, const Vector3& unit) {
  return v - v.dot(unit) * unit;
}

}  // namespace

LoopCurve::LoopCurve(const OutlineLoop& loop) : loop_(loop) {
  const std::size_t count = loop.points.size();
  for (Vector3& normal : loop_.normals) normal.stableNormalize();
  for (std::size_t i = 0; i < count; ++i)
    chords_.push_back((loop.points[(i + 1) % count] - loop.points[i]).norm());
  tangents_ = slopes(loop_.points, chords_);
  turns_ = slopes(loop_.normals, chords_);
  for (std::size_t i = 0; i < count; ++i) {
    // Chords are nearly arc lengths: the derivative by them has length 1.
    tangents_[i] = perpendicular(tangents_[i], loop_.normals[i]);
    if (tangents_[i].norm() > 1e-9) tangents_[i].normalize();
    turns_[i] = perpendicular(turns_[i], loop_.normals[i]);
  }
  if (loop.curvature.empty()) return;
  const auto [least, largest] = std::minmax_element(loop.curvature.begin(), loop.curvature.end());
  sign_ = *least > 0 ? 1 : *largest < 0 ? -1 : 0;
  for (const double value : loop.curvature) values_.push_back(sign_ == 0 ? value : std::log(sign_ * value));
  slopes_ = slopes(values_, chords_);
}

LoopCurve::Place LoopCurve::at(std::size_t i, double x) const {
  const std::size_t k = (i + 1) % piece_count();
  const double length = chords_[i];
  Place out;
  out.point = x == 0 ? loop_.points[i]
                     : hermite(loop_.points[i], tangents_[i], loop_.points[k], tangents_[k], length, x);
  const Vector3 tangent =
      hermite_slope(loop_.points[i], tangents_[i], loop_.points[k], tangents_[k], length, x);
  out.tangent = tangent.norm() > 1e-9 ? Vector3(tangent.normalized())
                                      : Vector3((loop_.points[k] - loop_.points[i]) / length);
  const Vector3 normal = perpendicular(
      hermite(loop_.normals[i], turns_[i], loop_.normals[k], turns_[k], length, x), out.tangent);
  // Between opposite normals the interpolation is undefined.
  out.normal = x == 0 || normal.norm() < 1e-9 ? loop_.normals[i] : normal.normalized();
  if (!values_.empty()) {
    if (sign_ == 0)  // linear, so that it stays between the given values
      out.curvature = (1 - x) * values_[i] + x * values_[k];
    else
      out.curvature =
          x == 0 ? loop_.curvature[i]
                 : sign_ * std::exp(hermite(values_[i], slopes_[i], values_[k], slopes_[k], length, x));
  }
  return out;
}

}  // namespace hariko
