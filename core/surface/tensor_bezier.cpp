#include "core/surface/tensor_bezier.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.hpp"
#include "core/surface/tensor_sums.hpp"

namespace hariko {

namespace {

using Vector4 = Eigen::Vector4d;

static_assert(max_bezier_degree == max_tensor_degree);

/// Bernstein polynomials of one direction, with derivatives.
struct Direction {
  BernsteinValues value, first, second;
  Direction(int degree, double x, Order order) {
    const double y = 1 - x;
    BernsteinValues lower, lowest;
    bernstein(degree, x, y, value);
    bernstein(degree - 1, x, y, lower);
    bernstein_derivative(degree, lower, first);
    if (order == Order::first) return;
    if (degree == 1) {
      second.fill(0);
      return;
    }
    bernstein(degree - 2, x, y, lowest);
    bernstein_derivative(degree - 1, lowest, lower);
    bernstein_derivative(degree, lower, second);
  }
};

struct Homogeneous {
  Vector4 value = Vector4::Zero(), ds = Vector4::Zero(), dt = Vector4::Zero(), dss = Vector4::Zero(),
          dst = Vector4::Zero(), dtt = Vector4::Zero();
};

/// Projection of a rational point by the quotient rule: S = A / w, S' = (A' - S w') / w, and so on.
PatchPoint project(const Homogeneous& h, Order order) {
  const double w = h.value.w();
  PatchPoint out;
  out.position = h.value.head<3>() / w;
  out.ds = (h.ds.head<3>() - out.position * h.ds.w()) / w;
  out.dt = (h.dt.head<3>() - out.position * h.dt.w()) / w;
  if (order == Order::first) return out;
  out.dss = (h.dss.head<3>() - 2 * out.ds * h.ds.w() - out.position * h.dss.w()) / w;
  out.dst = (h.dst.head<3>() - out.ds * h.dt.w() - out.dt * h.ds.w() - out.position * h.dst.w()) / w;
  out.dtt = (h.dtt.head<3>() - 2 * out.dt * h.dt.w() - out.position * h.dtt.w()) / w;
  return out;
}

PatchPoint polynomial_point(const BezierPatch& patch, const Vector2& at, Order order) {
  const int p = patch.degree_s, q = patch.degree_t;
  const Direction s(p, at.x(), order), t(q, at.y(), order);
  const Vector3* c = patch.points.data();
  PatchPoint out;
  out.position = tensor_sum(p, q, s.value, t.value, c);
  out.ds = tensor_sum(p, q, s.first, t.value, c);
  out.dt = tensor_sum(p, q, s.value, t.first, c);
  if (order == Order::first) return out;
  out.dss = tensor_sum(p, q, s.second, t.value, c);
  out.dst = tensor_sum(p, q, s.first, t.first, c);
  out.dtt = tensor_sum(p, q, s.value, t.second, c);
  return out;
}

PatchPoint rational_point(const BezierPatch& patch, const Vector4* c, const Vector2& at, Order order) {
  const int p = patch.degree_s, q = patch.degree_t;
  const Direction s(p, at.x(), order), t(q, at.y(), order);
  Homogeneous h;
  h.value = tensor_sum(p, q, s.value, t.value, c);
  h.ds = tensor_sum(p, q, s.first, t.value, c);
  h.dt = tensor_sum(p, q, s.value, t.first, c);
  if (order == Order::second) {
    h.dss = tensor_sum(p, q, s.second, t.value, c);
    h.dst = tensor_sum(p, q, s.first, t.first, c);
    h.dtt = tensor_sum(p, q, s.value, t.second, c);
  }
  return project(h, order);
}

}  // namespace

BezierPatchSet::BezierPatchSet(std::vector<BezierPatch> patches) : patches_(std::move(patches)) {
  homogeneous_.resize(patches_.size());
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    const BezierPatch& patch = patches_[k];
    HARIKO_ASSERT(!check_patch(patch, k), "the patches must be valid");
    for (std::size_t i = 0; i < patch.weights.size(); ++i) {
      const double w = patch.weights[i];
      const Vector3& p = patch.points[i];
      homogeneous_[k].emplace_back(w * p.x(), w * p.y(), w * p.z(), w);
    }
  }
}

PatchPoint BezierPatchSet::evaluate(Index patch, const Vector2& parameter, Order order) const {
  const BezierPatch& p = patches_[patch];
  return p.rational() ? rational_point(p, homogeneous_[patch].data(), parameter, order)
                      : polynomial_point(p, parameter, order);
}

void BezierPatchSet::positions(Index patch, std::span<const Vector2> parameters,
                               std::span<Vector3> out) const {
  const BezierPatch& at = patches_[patch];
  const int p = at.degree_s, q = at.degree_t;
  if (!at.rational()) {
    tensor_positions(p, q, at.points.data(), parameters, out);
    return;
  }
  BernsteinValues s, t;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    bernstein(p, parameters[k].x(), 1 - parameters[k].x(), s);
    bernstein(q, parameters[k].y(), 1 - parameters[k].y(), t);
    const Vector4 h = tensor_sum(p, q, s, t, homogeneous_[patch].data());
    out[k] = h.head<3>() / h.w();
  }
}

int BezierPatchSet::hull_degree(Index patch) const {
  const int degree = patches_[patch].degree_s + patches_[patch].degree_t;
  return degree <= TriangleCollocation::max_degree ? degree : 0;
}

void BezierPatchSet::hull(Index patch, const ParameterTriangle& triangle, std::span<const Vector3> samples,
                          std::span<HullBall> out) const {
  const int degree = hull_degree(patch);
  HARIKO_ASSERT(degree > 0, "this patch has no bound");
  if (patches_[patch].rational())
    rational_hull(patch, triangle, out);
  else
    triangle_collocation(degree).controls(samples, out);
}

/// The triangle's homogeneous control points have positive weights, as averages of the patch's, so the
/// projected points span a hull.
void BezierPatchSet::rational_hull(Index patch, const ParameterTriangle& triangle,
                                   std::span<HullBall> out) const {
  const BezierPatch& at = patches_[patch];
  const int p = at.degree_s, q = at.degree_t, degree = p + q;
  const TriangleCollocation& collocation = triangle_collocation(degree);
  const auto count = std::size_t(collocation.count());
  std::array<Vector4, 91> samples;
  std::size_t k = 0;
  double extent = 0;
  BernsteinValues s, t;
  for (int j = 0; j <= degree; ++j)
    for (int i = 0; i + j <= degree; ++i) {
      const Vector2 w = at_barycentric(triangle, double(i) / degree, double(j) / degree);
      bernstein(p, w.x(), 1 - w.x(), s);
      bernstein(q, w.y(), 1 - w.y(), t);
      samples[k] = tensor_sum(p, q, s, t, homogeneous_[patch].data());
      extent = std::max(extent, samples[k].head<3>().lpNorm<Eigen::Infinity>() / samples[k].w());
      ++k;
    }
  for (std::size_t i = 0; i < count; ++i) {
    const double* weight = collocation.row(int(i));
    Vector4 control = Vector4::Zero();
    double largest = 0;
    for (k = 0; k < count; ++k) {
      control += weight[k] * (samples[k] - samples[0]);
      largest = std::max(largest, samples[k].w());
    }
    control += samples[0];
    const double rounding = 2e-15 * collocation.amplification(int(i)) * largest;
    const bool positive = control.w() > 2 * rounding;
    out[i].centre =
        positive ? Vector3(control.head<3>() / control.w()) : Vector3(samples[0].head<3>() / samples[0].w());
    out[i].radius = positive ? rounding * 2 * extent / control.w() : std::numeric_limits<double>::infinity();
  }
}

}  // namespace hariko
