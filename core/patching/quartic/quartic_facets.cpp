// Extended quartic triangles for meshing: points at any parameters, and hulls over parameter triangles.

#include <algorithm>

#include "core/patching/quartic/quartic_patch.hpp"
#include "core/surface/triangle_collocation.hpp"

namespace hariko {

namespace {

using namespace quartic;

constexpr int degree = 4;
constexpr std::size_t node_count = 15;

/// Pair of control points between which an inner point is blended: p / (p + q) of the way from `second` to
/// `first` (equation (8)), where p and q are barycentric coordinates by number.
struct Slide {
  Control first, second;
  int r, p, q;
};
constexpr std::array<Slide, 3> slides{
    {{d211w, d211v, 0, 1, 2}, {d121w, d121u, 1, 0, 2}, {d112v, d112u, 2, 0, 1}}};

/// Point at (u, v, w) of the quartic with inner points `inner` at the corners u, v, w.
Vector3 quartic_point(const QuarticPatch& patch, const std::array<Vector3, 3>& inner, double u, double v,
                      double w) {
  const auto& d = patch.control;
  const double uu = u * u, vv = v * v, ww = w * w, uv = u * v, vw = v * w, wu = w * u;
  Vector3 out = (uu * uu) * d[d400] + (vv * vv) * d[d040] + (ww * ww) * d[d004];
  out += (4 * uu * uv) * d[d310] + (6 * uu * vv) * d[d220] + (4 * uv * vv) * d[d130];
  out += (4 * vv * vw) * d[d031] + (6 * vv * ww) * d[d022] + (4 * vw * ww) * d[d013];
  out += (4 * ww * wu) * d[d103] + (6 * ww * uu) * d[d202] + (4 * wu * uu) * d[d301];
  const double uvw = 12 * uv * w;
  return out + (uvw * u) * inner[0] + (uvw * v) * inner[1] + (uvw * w) * inner[2];
}

/// Blending weight of the pair's first point at barycentric coordinates x; one half at the corner r = 1,
/// where it depends on the direction and does not matter.
double share(const Slide& slide, const double x[3]) {
  const double sum = x[slide.p] + x[slide.q];
  return sum > 0 ? x[slide.p] / sum : 0.5;
}

Vector3 slid(const QuarticPatch& patch, const Slide& slide, double at) {
  return at * patch.control[slide.first] + (1 - at) * patch.control[slide.second];
}

/// Adds value and derivatives by (u, v, w) of the function of one inner point, 12 r^2 g with g = p^2 q / (p +
/// q).
void add_end(const Vector3& control, int r, int p, int q, const double x[3], PatchPoint& point,
             std::array<Vector3, 3>& gradient) {
  const double sum = x[p] + x[q];
  const double a = sum > 0 ? x[p] / sum : 0.5, b = sum > 0 ? x[q] / sum : 0.5;
  const double g = x[p] * x[q] * a, rr = 12 * x[r] * x[r];
  point.position += (rr * g) * control;
  gradient[std::size_t(r)] += (24 * x[r] * g) * control;
  gradient[std::size_t(p)] += (rr * sum * a * b * (a + 2 * b)) * control;
  gradient[std::size_t(q)] += (rr * sum * a * a * a) * control;
}

PatchPoint first_order_point(const QuarticPatch& patch, double u, double v, double w) {
  const auto& d = patch.control;
  const double x[3] = {u, v, w};
  // Boundary terms c x_i^a x_j^b, taken side by side.
  struct Side {
    int i, j;
    Control control[5];
  };
  constexpr Side sides[3] = {{0, 1, {d400, d310, d220, d130, d040}},
                             {1, 2, {d040, d031, d022, d013, d004}},
                             {2, 0, {d004, d103, d202, d301, d400}}};
  PatchPoint point;
  std::array<Vector3, 3> gradient;
  gradient.fill(Vector3::Zero());
  for (const Side& side : sides) {
    const double a = x[side.i], b = x[side.j], aa = a * a, bb = b * b;
    const Vector3 &c0 = d[side.control[0]], &c1 = d[side.control[1]], &c2 = d[side.control[2]],
                  &c3 = d[side.control[3]];
    // Each corner's own power belongs to the side that starts there.
    point.position += (aa * aa) * c0 + (4 * aa * a * b) * c1 + (6 * aa * bb) * c2 + (4 * a * bb * b) * c3;
    gradient[std::size_t(side.i)] +=
        (4 * aa * a) * c0 + (12 * aa * b) * c1 + (12 * a * bb) * c2 + (4 * bb * b) * c3;
    gradient[std::size_t(side.j)] += (4 * aa * a) * c1 + (12 * aa * b) * c2 + (12 * a * bb) * c3;
  }
  for (const Slide& slide : slides) {
    add_end(d[slide.first], slide.r, slide.p, slide.q, x, point, gradient);
    add_end(d[slide.second], slide.r, slide.q, slide.p, x, point, gradient);
  }
  point.ds = gradient[1] - gradient[0];
  point.dt = gradient[2] - gradient[0];
  return point;
}

}  // namespace

void QuarticPatchSet::positions(Index patch, std::span<const Vector2> parameters,
                                std::span<Vector3> out) const {
  const QuarticPatch& at = patches_[patch];
  std::array<Vector3, 3> inner;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const double v = parameters[k].x(), w = parameters[k].y();
    const double x[3] = {1 - v - w, v, w};
    for (std::size_t i = 0; i < 3; ++i) inner[i] = slid(at, slides[i], share(slides[i], x));
    out[k] = quartic_point(at, inner, x[0], x[1], x[2]);
  }
}

void QuarticPatchSet::first_order(Index patch, std::span<const Vector2> parameters,
                                  std::span<PatchPoint> out) const {
  const QuarticPatch& at = patches_[patch];
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const double v = parameters[k].x(), w = parameters[k].y();
    out[k] = first_order_point(at, 1 - v - w, v, w);
  }
}

// For blending weights held fixed within their intervals the patch is a quartic whose control points over the
// triangle are those for the middle weights, moved by at most the coefficient of an inner function times half
// of the interval's length in space. Each point of the patch is the point of one such quartic at the same
// parameter.
void QuarticPatchSet::hull(Index patch, const ParameterTriangle& triangle, std::span<const Vector3>,
                           std::span<HullBall> out) const {
  const QuarticPatch& at = patches_[patch];
  double corner[3][3];
  for (std::size_t c = 0; c < 3; ++c) {
    corner[c][1] = std::max(triangle[c].x(), 0.0);
    corner[c][2] = std::max(triangle[c].y(), 0.0);
    corner[c][0] = std::max(1 - triangle[c].x() - triangle[c].y(), 0.0);
  }
  std::array<Vector3, 3> middle;
  std::array<double, 3> half_slide;
  for (std::size_t i = 0; i < 3; ++i) {
    // p / (p + q) is constant along lines through the corner r = 1 and monotone across them: its extremes are
    // at corners of the triangle, and r = 1 itself adds none.
    double low = 1, high = 0;
    for (const auto& x : corner) {
      if (x[slides[i].p] + x[slides[i].q] < 1e-13) continue;
      low = std::min(low, share(slides[i], x));
      high = std::max(high, share(slides[i], x));
    }
    middle[i] = slid(at, slides[i], 0.5 * (low + high));
    half_slide[i] = std::max(0.0, 0.5 * (high - low)) *
                    (at.control[slides[i].first] - at.control[slides[i].second]).norm();
  }
  std::array<Vector3, node_count> samples;
  std::array<std::array<double, node_count>, 3> inner;
  std::size_t k = 0;
  for (int j = 0; j <= degree; ++j)
    for (int i = 0; i + j <= degree; ++i, ++k) {
      const Vector2 w = at_barycentric(triangle, double(i) / degree, double(j) / degree);
      const double x[3] = {1 - w.x() - w.y(), w.x(), w.y()};
      samples[k] = quartic_point(at, middle, x[0], x[1], x[2]);
      for (std::size_t c = 0; c < 3; ++c) inner[c][k] = 12 * x[0] * x[1] * x[2] * x[c];
    }
  const TriangleCollocation& collocation = triangle_collocation(degree);
  collocation.controls(samples, out);
  for (std::size_t c = 0; c < 3; ++c) {
    if (half_slide[c] == 0) continue;
    for (std::size_t i = 0; i < node_count; ++i) {
      const double* weight = collocation.row(int(i));
      double coefficient = 0;
      for (k = 0; k < node_count; ++k) coefficient += weight[k] * inner[c][k];
      out[i].radius += (std::abs(coefficient) + 1e-14) * half_slide[c];
    }
  }
}

}  // namespace hariko
