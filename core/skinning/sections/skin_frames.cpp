#include "core/skinning/sections/skin_frames.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/assert.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/rotation.hpp"
#include "core/skinning/skin_messages.hpp"

namespace hariko {

namespace {

constexpr int samples_per_span = 64;
constexpr double straight_path = 15 * std::numbers::pi / 180;

Vector3 unit_tangent(const SubdivisionCurve& path, double v) {
  return evaluate(path, v).first.normalized();
}

/// Some unit vector perpendicular to t.
Vector3 across(const Vector3& t) {
  Vector3 axis = Vector3::Zero();
  int least = 0;
  t.cwiseAbs().minCoeff(&least);
  axis[least] = 1;
  return (axis - axis.dot(t) * t).normalized();
}

/// Reference vectors by the double reflection method, from sample to sample.
std::vector<Vector3> transported(const SubdivisionCurve& path) {
  const int count = samples_per_span * path.spans();
  std::vector<Vector3> out{across(unit_tangent(path, 0))};
  for (int i = 0; i < count; ++i) {
    const double v0 = double(i) / count, v1 = double(i + 1) / count;
    const Vector3 t0 = unit_tangent(path, v0), t1 = unit_tangent(path, v1);
    const Vector3 step = evaluate(path, v1).position - evaluate(path, v0).position;
    out.push_back(carried_along(out.back(), t0, t1, step));
  }
  return out;
}

/// Distributes the angle between the last and the first reference over the arc length.
void close(const SubdivisionCurve& path, std::vector<Vector3>& reference) {
  const int count = int(reference.size()) - 1;
  const Vector3 t = unit_tangent(path, 0);
  const Vector3 &last = reference.back(), &first = reference.front();
  const double angle = signed_angle(last, first, t);
  std::vector<double> arc{0};
  for (int i = 0; i < count; ++i)
    arc.push_back(
        arc.back() +
        (evaluate(path, double(i + 1) / count).position - evaluate(path, double(i) / count).position).norm());
  for (int i = 0; i <= count; ++i) {
    const Eigen::AngleAxisd turn(angle * arc[std::size_t(i)] / arc.back(),
                                 unit_tangent(path, double(i) / count));
    reference[std::size_t(i)] = turn * reference[std::size_t(i)];
  }
}

}  // namespace

double total_turning(const SubdivisionCurve& curve) {
  const int count = samples_per_span * curve.spans();
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const Vector3 a = unit_tangent(curve, double(i) / count), b = unit_tangent(curve, double(i + 1) / count);
    sum += angle_between(a, b);
  }
  return sum;
}

Result<SkinFrames> SkinFrames::make(const Skin& skin) {
  SkinFrames out;
  out.path_ = skin.path;
  out.rail_ = skin.second_rail;
  const int count = samples_per_span * skin.path.spans();
  const double size = length(skin.path);
  const Message cusp =
      make_error(e_path_cusp, "The path has a cusp or a zero-length part.", "Move its points apart there.");
  for (int i = 0; i <= count; ++i)
    if (!(evaluate(skin.path, double(i) / count).first.norm() > 1e-9 * size)) return cusp;
  out.mode_ = skin.frame;
  if (out.mode_ == FrameMode::automatic)
    out.mode_ = skin.second_rail                           ? FrameMode::two_rail
                : total_turning(skin.path) > straight_path ? FrameMode::rotation_minimising
                                                           : FrameMode::translate;
  if (out.mode_ == FrameMode::two_rail) {
    if (!skin.second_rail || skin.second_rail->size() < (skin.second_rail->closed ? 3 : 2) ||
        skin.second_rail->closed != skin.path.closed)
      return make_error(e_rail, "Two rails need a second path, open or closed like the first.",
                        "Draw the second rail, or use other frames.");
    for (int i = 0; i <= count; ++i) {
      const double v = double(i) / count;
      const Matrix3 frame = rail_frame(out.position(v), out.rail(v));
      if (!frame.allFinite() || !(std::abs(frame.determinant()) > 1e-9 * std::pow(frame.col(0).norm(), 3)))
        return make_error(e_path_cusp,
                          "The rails meet, or one is above the other, so no frame lies between them.",
                          "Move the rails apart.");
    }
  }
  if (out.mode_ == FrameMode::rotation_minimising) {
    out.reference_ = transported(skin.path);
    if (skin.path.closed) close(skin.path, out.reference_);
  }
  return out;
}

Matrix3 SkinFrames::rail_frame(const Vector3& first, const Vector3& second) {
  const Vector3 chord = second - first;
  const double width = chord.norm();
  const Vector3 x = chord / width;
  const Vector3 up(0, 0, 1);
  const Vector3 z = (up - up.dot(x) * x).normalized();
  Matrix3 out;
  out.col(0) = chord;
  out.col(1) = z.cross(x) * width;
  out.col(2) = z * width;
  return out;
}

Matrix3 SkinFrames::frame(double v) const {
  if (mode_ == FrameMode::translate) return Matrix3::Identity();
  if (mode_ == FrameMode::two_rail) return rail_frame(position(v), rail(v));
  const int count = int(reference_.size()) - 1;
  double x = v;
  if (path_.closed) x -= std::floor(x);
  x = std::clamp(x, 0.0, 1.0) * count;
  const int i = std::min(int(x), count - 1);
  const double f = x - i;
  const Vector3 t = unit_tangent(path_, v);
  Vector3 r = (1 - f) * reference_[std::size_t(i)] + f * reference_[std::size_t(i) + 1];
  r = (r - r.dot(t) * t).normalized();
  Matrix3 out;
  out.col(0) = r;
  out.col(1) = t.cross(r);
  out.col(2) = t;
  return out;
}

}  // namespace hariko
